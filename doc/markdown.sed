# Formulas and pictures of the Markdown pages, as Doxygen writes them
/^```math$/,/^```$/ {
  s/^```math$/@f[/
  s/^```$/@f]/
}
s/\$`\([^`]*\)`\$/@f$\1@f$/g
s|<img src="doc/figures/|<img src="|
s/\[\([^]]*\)\](references\.bib#\([A-Za-z0-9]*\))/\1 @cite \2/g
s,](\(\.\./\)\?prm/\(tutorial/\)\?,](,g
s|](paraview/|](|g
s|](python/|](|g
