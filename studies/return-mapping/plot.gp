load style
cases = "return no-return-1 no-return-3 no-return-8"
set xlabel "strain along the bar, %"
set ylabel "stress along the bar, MPa"
do for [m in "fem-one-point sph-corrected sph-classic-full"] {
  set output figure("fig23-".m)
  set title m." at dt = 0.1 {/Symbol m}s"
  if (has("fig23-".m)) {
    plot for [i = 1:words(cases)] file("fig23-".m) using (column(word(cases, \
        i)." along")):(column(word(cases, i))) with lines ls 30 + i title word(cases, i)
  }
}
