load style
set xlabel "depth below the contact, on the axis, mm"
set ylabel "vertical strain, %"
names = "'fem-full' 'sph-classic-share h' 'sph-classic-share h/2' 'sph-corrected' ". \
    "'A=fem-full' 'A=sph-corrected'" # the last two: gnuplot knows a column by its name up to a comma
shown = "'fem-full' 'sph-classic-share, h = 2 d' 'sph-classic-share, h = d' 'sph-corrected' ". \
    "'steel FEM, concrete SPH' 'steel SPH, concrete FEM'"
styles = "1 6 5 10 11 3"
do for [f in "table2-strain table2-side-strain plastic-strain"] {
  set output figure(f)
  set xlabel (f eq "table2-side-strain" ? "distance from the axis at mid-height of the concrete, mm" : \
      "depth below the contact, on the axis, mm")
  set ylabel (f eq "plastic-strain" ? "equivalent plastic strain, %" : "vertical strain, %")
  if (has(f)) {
    plot for [i = 1:words(names)] file(f) using "distance_mm":word(names, \
        i) with linespoints ls (int(word(styles, i))) title word(shown, i)
  }
}

set output figure("fig21-equivalent")
set title "equivalent stress in the concrete block, MPa (fem-full)"
set xlabel "x, mm"
set ylabel "y, mm"
unset key
set size ratio -1
set palette defined (0 "#332288", 1 "#56B4E9", 2 "#F0E442", 3 "#D55E00")
set cbrange [0:*]
if (has("fig21-equivalent-000")) {
  plot for [k = 0:20] file(sprintf("fig21-equivalent-%03d", \
      5 * k)) using "distance_mm":(5 * k):"fem-full" with points pt 5 ps 2.4 palette
}
