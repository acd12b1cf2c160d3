# Common to all figures. femsph gives: format ("svg" or "png"), out, data, style.
if (format eq "svg") {
  set terminal svg size 800,520 enhanced font "DejaVu Sans,15" background "white"
} else {
  set terminal pngcairo size 1600,1040 enhanced font "DejaVu Sans,15" fontscale 1.6 linewidth 2 pointscale \
      1.8 background "white"
}
set datafile separator comma
set encoding utf8
set border 3 lw 1
set tics nomirror out
set grid lc rgb "#dddddd" lw 0.6 dt 1
set key outside right top spacing 1.3 samplen 2.6

figure(name) = out."/".name.".".format
file(name) = data."/".name.".csv"
# More than its header line: a quick run leaves some series empty.
has(name) = int(system("wc -l < '".file(name)."' 2>/dev/null || echo 0")) > 1

# Colours: Okabe and Ito, and Tol, which the colour-blind tell apart. FEM: solid lines, filled marks. SPH:
# dashed lines, open marks.
set style line 1 lc rgb "#0072B2" lw 2 dt 1 pt 5 ps 0.9
set style line 2 lc rgb "#56B4E9" lw 2 dt 1 pt 7 ps 0.9
set style line 3 lc rgb "#009E73" lw 2 dt 1 pt 9 ps 1.0
set style line 4 lc rgb "#CC79A7" lw 2 dt 1 pt 13 ps 1.1
set style line 5 lc rgb "#D55E00" lw 2 dt (10, 5) pt 4 ps 0.9
set style line 6 lc rgb "#E69F00" lw 2 dt (10, 5) pt 6 ps 0.9
set style line 7 lc rgb "#8B5A2B" lw 2 dt (10, 5) pt 8 ps 1.0
set style line 8 lc rgb "#332288" lw 2 dt (10, 4, 3, 4) pt 10 ps 1.0
set style line 9 lc rgb "#999933" lw 2 dt (10, 4, 3, 4) pt 12 ps 1.1
set style line 10 lc rgb "#AA4499" lw 2 dt (10, 5) pt 14 ps 1.0
set style line 11 lc rgb "#117733" lw 2 dt (10, 4, 3, 4) pt 6 ps 1.0
set style line 12 lc rgb "#882255" lw 2.4 dt 1 pt 7 ps 0.9
# Theory and guides.
set style line 20 lc rgb "black" lw 1.6 dt (7, 4)
set style line 21 lc rgb "#777777" lw 1.2 dt 3
# A ladder of cases of one method: light and coarse to dark and fine.
set style line 31 lc rgb "#E69F00" lw 2 dt 1 pt 4
set style line 32 lc rgb "#56B4E9" lw 2 dt (10, 5) pt 6
set style line 33 lc rgb "#009E73" lw 2 dt (10, 4, 3, 4) pt 8
set style line 34 lc rgb "#0072B2" lw 2 dt 1 pt 10
set style line 35 lc rgb "#332288" lw 2 dt (10, 5) pt 12

fem = "fem-full fem-sri fem-one-point fem-assumed-strain"
sph = "sph-classic-share sph-classic-full sph-classic-trapezoid sph-virtual sph-weight sph-corrected sph-corrected-own-volume sph-updated"
order = fem." ".sph
style_of(method) = int(sum [i = 1:words(order)] (word(order, i) eq method ? i : 0))
