load style
squares = "1_1 1_2 1_3 1_4 1_5"
cells = "20x2 40x4 50x5 100x10 200x20"

set ylabel "height, mm"
do for [name in "fig13-root-stress fig13-inner-stress"] {
  set output figure(name)
  set xlabel (name eq "fig13-root-stress" ? "stress along the beam at the root, MPa" : \
      "stress along the beam at x = 100 mm, MPa")
  if (has(name)) {
    plot for [i = 1:words(squares)] file(name) using word(squares, \
        i):"distance_mm" with lines ls 30 + i title word(cells, i), \
         file(name) using "theory":"distance_mm" with lines ls 20 title "beam theory"
  }
}

set xlabel "time, ms"
set ylabel "deflection of the tip, mm"
set output figure("fig14-tip")
if (has("fig14-tip")) {
  plot for [i = 1:words(squares)] file("fig14-tip") using "time_ms":word(squares, \
      i) with lines ls 30 + i title word(cells, i), \
       file("fig14-tip") using "time_ms":"theory" with lines ls 20 title "beam theory"
}
slices = "1_4_1 1_4_2 1_4_3 1_4"
slice_cells = "10x10 20x10 50x10 100x10"
set output figure("fig15-tip")
if (has("fig15-tip")) {
  plot for [i = 1:words(slices)] file("fig15-tip") using "time_ms":word(slices, \
      i) with lines ls 30 + i title word(slice_cells, i), \
       file("fig15-tip") using "time_ms":"theory" with lines ls 20 title "beam theory"
}
set output figure("step-tip")
if (has("step-tip")) {
  plot file("step-tip") using "time_ms":"fem-full" with lines ls 1 title "fem-full 100x10, no damping", \
       file("step-tip") using "time_ms":"theory" with lines ls 20 title "beam theory, ten modes"
}

cells_of(name) = name eq "1_4_1" ? "10x10" : name eq "1_4_2" ? "20x10" : name eq "1_4_3" ? "50x10" : name \
    eq "1_4" ? "100x10" : name
set output figure("aspect-error")
set style data histogram
set style histogram clustered gap 1
set style fill solid 0.85 border -1
set xlabel "cells along and over the height"
set yrange [* < 0 : 0 < *]
set ylabel "error of the tip's deflection, %"
set xtics nomirror noenhanced
if (has("aspect-error")) {
  plot for [m in fem] file("aspect-error") using m:xtic(cells_of(strcol(1))) ls style_of(m) lw 0.5 dt 1 \
      title m
}

set style data lines
set xtics autofreq
set autoscale y
set logscale xy
set xrange [4:60]
set xtics (5, 10, 20, 25, 50)
set xlabel "cell edge d, mm"
do for [name in "tip-error tip-error-limit"] {
  set output figure(name)
  set ylabel (name eq "tip-error" ? "error against beam theory, %" : \
      "error against the converged elastic solution, %")
  plot for [m in fem] file(name) using (column("spacing_mm")):(abs(column(m))) with linespoints ls \
      style_of(m) title m, \
       10.0 * (x / 50)**2 with lines ls 21 title "slope 2"
}
