load style

methods = "fem-full fem-one-point fem-assumed-strain sph-classic-share sph-corrected sph-updated"
# A method whose run stopped early is missing from the file.
columns(name) = system("head -1 '".file(name)."' | tr ',' ' ' | tr -d '\\r'")
present(name) = \
    system("for m in ".methods."; do head -1 '".file(name)."' | tr ',' '\\n' | tr -d '\\r' | " . \
      "grep -qx $m && printf '%s ' $m; done")

set output figure("spin-energy")
set title "spinning plate, ten turns (exact: 229.17 kJ)"
set xlabel "time, s"
set ylabel "kinetic energy, kJ"
set yrange [226:234]
if (has("spin-energy")) {
  plot for [m in present("spin-energy")] file("spin-energy") using "time_s":m with lines ls style_of(m) \
      title m
}
set yrange [*:*]
set output figure("bending-top")
set title "bending column"
set ylabel "displacement of the top, m"
if (has("bending-top")) {
  plot for [m in present("bending-top")] file("bending-top") using "time_s":m with lines ls style_of(m) \
      title m
}
set output figure("twist-corner")
set title "twisting column"
set ylabel "x displacement of a top corner, m"
set yrange [-1.5:0.5]
if (has("twist-corner")) {
  plot for [m in present("twist-corner")] file("twist-corner") using "time_s":m with lines ls style_of(m) \
      title m
}
set yrange [*:*]
set output figure("strip-stress")
set title "strip held at 10 % stretch (exact: 1 MPa)"
set xlabel "time, ms"
set ylabel "stress in the middle, MPa"
set yrange [0.8:1.4]
if (has("strip-stress")) {
  plot for [m in present("strip-stress")] file("strip-stress") using "time_ms":m with lines ls style_of(m) \
      title m
}
set yrange [*:*]
set output figure("wander")
set title "free bar with an added wave of two spacings (exact: 0)"
set ylabel "displacement of the middle, {/Symbol m}m"
if (has("wander")) {
  plot for [m in present("wander")] file("wander") using "time_ms":m with lines ls style_of(m) title m
}
set output figure("rings-force")
set title "colliding rings"
set ylabel "contact force per metre of depth, kN"
if (has("rings-force")) {
  plot for [m in present("rings-force")] file("rings-force") using "time_ms":m with lines ls style_of(m) \
      title m
}
