load style
scenes = "bar cantilever solid wave swing plastic"
plain = "fem-full fem-sri fem-one-point fem-assumed-strain sph-classic-share_h=1d sph-corrected_h=1d sph-corrected-own-volume_h=1d"
smoothing = \
    "sph-classic-share_h=1d sph-classic-share_h=1.2d sph-classic-share_h=1.4d sph-corrected_h=1d sph-corrected_h=1.2d sph-corrected_h=1.4d"

# Methods by their names in tables; "_" stands for the space in a list of words.
name(m) = system("printf '%s' '".m."' | tr _ ' '")
rows(s, m) = sprintf("< awk -F, 'NR == 1 || $1 == \"%s\"' '%s'", name(m), file("rungs-".s))
some(s, m) = int(system(sprintf("awk -F, '$1 == \"%s\"' '%s' 2>/dev/null | wc -l", name(m), \
    file("rungs-".s)))) > 0
# A fitted exponent of ladders.csv, by its column: 3 order, 5 error over CPU time, 6 CPU time over unknowns.
fitted(s, m, \
    k) = \
    system(sprintf("awk -F, '$1 == \"%s\" && $2 == \"%s\" && $%d != \"\" {printf \"%%.2f\", $%d}' '%s'", s, \
    name(m), k, k, file("ladders")))
# short enough for two columns of the key
shown_as(m) = system("printf '%s' '".name(m)."' | sed s/sph-corrected-own-volume/sph-own-volume/")
label(s, m, k) = shown_as(m).(strlen(fitted(s, m, k)) > 0 ? sprintf(" (%s)", fitted(s, m, k)) : "")
style_in(list, i) = \
    list eq plain ? (i < 5 ? i : i == 5 ? 5 : i == 6 ? 10 : 11) : i == 1 ? 5 : i == 4 ? 10 : 40 + i

# Warm colours: classic SPH; cold colours: corrected SPH.
set style line 42 lc rgb "#E69F00" lw 2 dt (10, 4, 3, 4) pt 6
set style line 43 lc rgb "#8B5A2B" lw 2 dt (3, 3) pt 8
set style line 45 lc rgb "#332288" lw 2 dt (10, 4, 3, 4) pt 10
set style line 46 lc rgb "#56B4E9" lw 2 dt (3, 3) pt 12
set style line 40 lc rgb "#cccccc" lw 6 dt 1
set logscale xy
set format xy "%g"
set key outside bottom center horizontal maxcols 2 width -9 samplen 3

do for [s in scenes] {
  if (has("rungs-".s)) {
    do for [kind in "methods smoothing"] {
      list = kind eq "methods" ? plain : smoothing
      shown = ""
      do for [m in list] { if (some(s, m)) { shown = shown." ".m } }
      index_of(m) = int(sum [i = 1:words(list)] (word(list, i) eq m ? i : 0))

      if (kind eq "methods") { set key width -2 } else { set key width -9 }
      set output figure("work-".kind."-".s)
      set xlabel "CPU time of a run, s (in brackets: slope)"
      set ylabel "error, %"
      plot file("front-".s) using "cpu_s":"error_percent" with steps ls 40 title \
          "best of all (Pareto front)", \
           for [m in shown] rows(s, \
               m) using (column("cpu_s")):(abs(column("error_percent"))) with linespoints ls style_in(list, \
               index_of(m)) title label(s, m, 5)

      set output figure("order-".kind."-".s)
      set xlabel "spacing or cell edge d, mm (in brackets: order)"
      plot for [m in shown] rows(s, \
          m) using (column("spacing_mm")):(abs(column("error_percent"))) with linespoints ls style_in(list, \
          index_of(m)) title label(s, m, 3)

      if (kind eq "methods") {
        set output figure("size-".s)
        set xlabel "unknowns (in brackets: slope)"
        set ylabel "CPU time of a run, s"
        plot for [m in shown] rows(s, \
            m) using (column("dof")):(column("cpu_s")) with linespoints ls style_in(list, \
            index_of(m)) title label(s, m, 6)
      }
    }
  }
}
