load style
methods = "sph-classic-share sph-virtual sph-weight sph-corrected"

set output figure("fig7-stress")
set xlabel "stress along the beam at x = 100 mm, MPa"
set ylabel "height, mm"
set title "d = 2.5 mm"
if (has("fig7-stress")) {
  plot for [m in methods] file("fig7-stress") using m:"distance_mm" with linespoints ls style_of(m) title m, \
       file("fig7-stress") using "theory":"distance_mm" with lines ls 20 title "beam theory"
}

set output figure("fig8-tip")
set xlabel "time, ms"
set ylabel "deflection of the tip, mm"
if (has("fig8-tip")) {
  plot for [m in methods] file("fig8-tip") using "time_ms":m with lines ls style_of(m) title m, \
       file("fig8-tip") using "time_ms":"theory" with lines ls 20 title "beam theory"
}

unset title
set logscale xy
set xrange [2:12]
set xtics (2.5, 5, 10)
set xlabel "spacing d, mm"
do for [name in "tip-error fibre-error"] {
  set output figure(name)
  set ylabel (name eq "tip-error" ? "error of the tip's deflection, %" : \
      "error of the outer fibre's stress, %")
  plot for [m in methods] file(name) using (column("spacing_mm")):(abs(column(m))) with linespoints ls \
      style_of(m) title m, \
       10.0 * x / 10 with lines ls 21 title "slope 1"
}
