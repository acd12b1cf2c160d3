load style
cases = "4/sign/return 4/principal-3/return 4/sign/none-1 4/sign/none-3 4/sign/none-8"
set xlabel "time, ms"
set ylabel "deflection of midspan, mm"
do for [m in "fem-full sph-classic-share sph-corrected"] {
  set output figure("fig25-".m)
  set title m.", 4 m/s"
  if (has("fig25-".m)) {
    plot for [i = 1:words(cases)] file("fig25-".m) using "time_ms":word(cases, \
        i) with lines ls 30 + i title word(cases, i), \
         -36 with lines ls 20 title "measured peak", -30 with lines ls 21 title "measured residual"
  }
}
