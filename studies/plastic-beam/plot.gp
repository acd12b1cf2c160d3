load style

set xlabel "time, {/Symbol m}s"
set ylabel "stress 20 mm from the wall, MPa"
do for [v in "5 10 20"] {
  set output figure("wall-".v)
  set title v." m/s"
  if (has("wall-".v)) {
    plot for [m in "fem-full sph-corrected"] file("wall-".v) using "time_us":m with lines ls style_of(m) \
        title m, \
         file("wall-".v) using "time_us":"theory" with lines ls 20 title "1D theory (plateau)"
  }
}

methods = "fem-full fem-assumed-strain sph-corrected"
set title "perfectly plastic cantilever, load beyond its limit load"
set output figure("hinge-stress")
set xlabel "stress along the beam at x = 20 mm, MPa"
set ylabel "height, mm"
if (has("hinge-stress")) {
  plot for [m in methods] file("hinge-stress") using m:"distance_mm" with lines ls style_of(m) title m
}
set output figure("hinge-tip")
set xlabel "time, ms"
set ylabel "deflection of the tip, mm"
if (has("hinge-tip")) {
  plot for [m in methods] file("hinge-tip") using "time_ms":m with lines ls style_of(m) title m
}
