load style
cases = "d=20mm d=10mm d=5mm d=2.5mm"
methods = "sph-classic-share sph-classic-full sph-corrected-own-volume sph-corrected fem-full"

set ylabel "height, mm"
set xlabel "stress along the beam at x = 100 mm, MPa"
do for [name in "fig16-stress-share fig16-stress-own-volume fig16-stress-corrected"] {
  set output figure(name)
  set title (name eq "fig16-stress-share" ? "sph-classic-share" : name eq "fig16-stress-own-volume" ? \
      "sph-corrected-own-volume" : "sph-corrected")
  if (has(name)) {
    plot for [i = 1:words(cases)] file(name) using word(cases, \
        i):"distance_mm" with linespoints ls 30 + i title word(cases, i), \
         file(name) using "theory":"distance_mm" with lines ls 20 title "beam theory"
  }
}

set xlabel "time, ms"
set ylabel "deflection of the tip, mm"
do for [name in "fig17-tip-share fig17-tip-corrected"] {
  set output figure(name)
  set title (name eq "fig17-tip-share" ? "sph-classic-share" : "sph-corrected")
  if (has(name)) {
    plot for [i = 1:words(cases)] file(name) using "time_ms":word(cases, \
        i) with lines ls 30 + i title word(cases, i), \
         file(name) using "time_ms":"theory" with lines ls 20 title "beam theory"
  }
}

unset title
set logscale xy
set xrange [2:60]
set xtics (2.5, 5, 10, 20, 50)
set xlabel "spacing or cell edge d, mm"
do for [name in "tip-error tip-error-limit"] {
  set output figure(name)
  set ylabel (name eq "tip-error" ? "error against beam theory, %" : \
      "error against the converged elastic solution, %")
  plot for [m in methods] file(name) using (column("spacing_mm")):(abs(column(m))) with linespoints ls \
      style_of(m) title m, \
       20.0 * x / 10 with lines ls 21 title "slope 1", \
       1.0 * (x / 10)**2 with lines ls 21 dt 5 title "slope 2"
}
