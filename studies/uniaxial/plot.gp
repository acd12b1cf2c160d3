load style
methods = "sph-classic-share sph-virtual sph-weight sph-corrected fem-full"

set xlabel "time, ms"
set ylabel "stress at the centre, MPa"
do for [name in "fig5-stress fig9-stress"] {
  set output figure(name)
  set title (name eq "fig5-stress" ? "d = 10 mm" : "d = 2.5 mm")
  if (has(name)) {
    plot for [m in methods] file(name) using "time_ms":m with lines ls style_of(m) title m, \
         file(name) using "time_ms":"theory" with lines ls 20 title "theory F/A"
  }
}

set ylabel "displacement of the end, {/Symbol m}m"
do for [name in "fig6-displacement fig10-displacement"] {
  set output figure(name)
  set title (name eq "fig6-displacement" ? "d = 10 mm" : "d = 2.5 mm")
  if (has(name)) {
    plot for [m in methods] file(name) using "time_ms":m with lines ls style_of(m) title m, \
         file(name) using "time_ms":"theory" with lines ls 20 title "theory F L/(E A)"
  }
}

unset title
set logscale xy
set xrange [2:25]
set xtics (2.5, 5, 10, 20)
set xlabel "spacing d, mm"
slope(d) = 40.0 * d / 10
do for [name in "fig11-displacement-error stress-error"] {
  set output figure(name)
  set ylabel (name eq "stress-error" ? "error of the stress, %" : "error of the displacement, %")
  plot for [m in methods] file(name) using (column("spacing_mm")):(abs(column(m))) with linespoints ls \
      style_of(m) title m, \
       slope(x) with lines ls 21 title "slope 1"
}
