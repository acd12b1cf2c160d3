load style
four = "sph-corrected-own-volume sph-corrected fem-full fem-assumed-strain"

set output figure("bar-stress")
set title "bar under a traction of 1 MPa, d = 12.5 mm"
set xlabel "distance from the fixed end, mm (right: loaded end)"
set ylabel "stress, MPa"
set yrange [0.6:1.5]
if (has("bar-stress")) {
  plot for [m in four] file("bar-stress") using "distance_mm":m with lines ls style_of(m) title m, \
      1 with lines ls 20 title "exact"
}
set autoscale y

set logscale xy
set format y "%g"
set xlabel "spacing or cell edge d, mm"
set title "cantilever: deflection of the tip"
set output figure("tip-error")
set ylabel "error against the converged elastic solution, %"
set xtics (5, 6.25, 12.5, 25, 50)
set xrange [4:60]
if (has("tip-error")) {
  plot for [m in four] file("tip-error") using (column("spacing_mm")):(abs(column(m))) with linespoints ls \
      style_of(m) title m, \
       0.5 * (x / 12.5)**2 with lines ls 21 dt 5 title "slope 2"
}
set title "cantilever in 3D, 25 mm deep: deflection of the tip"
set output figure("solid-error")
if (has("solid-error")) {
  plot for [m in four] file("solid-error") using (column("spacing_mm")):(abs(column(m))) with linespoints \
      ls style_of(m) title m, \
       1.0 * (x / 12.5)**2 with lines ls 21 dt 5 title "slope 2"
}
set title "cantilever: axial stress over the section at mid-length (L2)"
set output figure("section-error")
set ylabel "L2 error against beam theory, %"
if (has("section-error")) {
  plot for [m in four] file("section-error") using (column("spacing_mm")):(abs(column(m))) with linespoints \
      ls style_of(m) title m, \
       2.0 * (x / 12.5)**2 with lines ls 21 dt 5 title "slope 2"
}
set xrange [2.5:16]
set xtics (3.125, 6.25, 12.5)
set title "thick cylinder under pressure: displacement of the bore"
set output figure("bore-error")
set ylabel "error, %"
if (has("bore-error")) {
  plot for [m in four] file("bore-error") using (column("spacing_mm")):(abs(column(m))) with linespoints ls \
      style_of(m) title m, \
       0.2 * (x / 12.5)**2 with lines ls 21 dt 5 title "slope 2"
}
set title "thick cylinder under pressure: radial stress at the bore"
set output figure("wall-error")
if (has("wall-error")) {
  plot for [m in four] file("wall-error") using (column("spacing_mm")):(abs(column(m))) with linespoints ls \
      style_of(m) title m, \
       5.0 * (x / 12.5)**2 with lines ls 21 dt 5 title "slope 2"
}

# Own volumes; whole cells with local dilatation; whole cells with mean dilatation.
changed = "own-volume-local whole-cells-local sph-corrected fem-assumed-strain"
style_changed(m) = m eq "own-volume-local" ? 11 : m eq "whole-cells-local" ? 6 : style_of(m)
set xtics (2.5, 5, 10, 12.5)
set xrange [2:16]
set title "plastic cylinder: hoop stress at the outer surface"
set output figure("plastic-error")
if (has("plastic-error")) {
  plot for [m in changed] file("plastic-error") using (column("spacing_mm")):(abs(column(m))) with \
      linespoints ls style_changed(m) title m
}
unset logscale
set xtics autofreq
set autoscale
set title "nu = 0.4999, d = 6.25 mm: radial stress through the wall"
set xlabel "distance from the bore, mm"
set ylabel "radial stress, MPa"
set output figure("pressure")
lame(x) = 100.0 / 3 * (1 - (200.0 / (100 + x))**2)
if (has("pressure")) {
  plot [0:100] for [m in changed] file("pressure") using "distance_mm":m with lines ls style_changed(m) \
      title m, lame(x) with lines ls 20 title "exact"
}
