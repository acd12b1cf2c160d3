load style
methods = "sph-classic-full sph-classic-share sph-corrected"

set output figure("fig18-weight")
set style data histogram
set style histogram clustered gap 1
set style fill solid 0.85 border -1
set xlabel "beam (d = 2.5 mm)"
set ylabel "loss of kernel sum at the surface, %"
set xtics noenhanced
set yrange [0:*]
if (has("fig18-weight")) {
  plot file("fig18-weight") using "sph-classic-full":xtic(1) ls style_of("sph-classic-full") lw 0.5 dt 1 \
      title "kernel sum, h = d", \
       25.0 with lines ls 21 title "1 of 4 nearest neighbours (2D)", \
           100.0 / 6 with lines ls 20 title "1 of 6 nearest neighbours (3D)"
}

set output figure("fig19-tip-error")
set style data histogram
set style histogram clustered gap 1
set style fill solid 0.85 border -1
set xlabel "depth of the beam (11, 6 and 3 particles), or plane stress"
set ylabel "error of the tip's deflection, %"
set xtics noenhanced
set yrange [* < 0 : 0 < *]
if (has("fig19-tip-error")) {
  plot for [m in methods] file("fig19-tip-error") using m:xtic(1) ls style_of(m) lw 0.5 dt 1 title m, \
       0 with lines ls 20 title "beam theory"
}

set style data lines
set output figure("fig19-tip")
cases = "'25 mm' '12.5 mm' '5 mm'"
set xtics autofreq
set autoscale y
set xlabel "time, ms"
set ylabel "deflection of the tip, mm"
set title "sph-classic-full"
# Beam theory, mm: P L^3/(3 E I) of depth-25.toml; the loads give all depths the same deflection.
tip = -1e3 * 25e3 * 0.3**3 / (3 * 210e9 * (0.025 * 0.1**3 / 12))
if (has("fig19-tip")) {
  plot for [i = 1:words(cases)] file("fig19-tip") using "time_ms":word(cases, \
      i) with lines ls 30 + i title word(cases, i), \
       tip with lines ls 20 title "beam theory"
}
