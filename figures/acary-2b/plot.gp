# Run with gnuplot in this folder.
if (!exists('folder')) folder = ''
set encoding utf8
set datafile separator comma
set border 3 lc rgb '#555555'
set tics nomirror out
set grid lt 1 lc rgb '#e6e6e6' lw 1
set key outside right top reverse Left samplen 2
set palette defined (0 '#30123b', 1 '#4171d6', 2 '#1fb5b0', 3 '#5fb94a', 4 '#e0a11b', 5 '#c4391d')
set linetype 1 lc rgb '#30123b'
set linetype 2 lc rgb '#4171d6'
set linetype 3 lc rgb '#1fb5b0'
set linetype 4 lc rgb '#5fb94a'
set linetype 5 lc rgb '#e0a11b'
set linetype 6 lc rgb '#c4391d'
set linetype 7 lc rgb '#8c564b'
set linetype 8 lc rgb '#7f7f7f'
set title '21 steel balls of 10 mm, and with a tenth of 50 mm' noenhanced
set xlabel 'triplet i'
set ylabel 'α_i = p_i / p_{i+1}'
set xrange [0.5:19.5]
set terminal pngcairo size 1200,750 font 'sans,14'
set output folder.'acary-2b.png'
plot 'plot.csv' index 0 using 1:2 with linespoints lw 2 pt 7 ps 0.8 lt 1 title 'equal balls', 'plot.csv' index 1 using 1:2 with linespoints lw 2 pt 7 ps 0.8 lt 2 title 'big tenth ball'
set terminal svg size 800,500 dynamic font 'sans,13' background 'white'
set output folder.'acary-2b.svg'
plot 'plot.csv' index 0 using 1:2 with linespoints lw 2 pt 7 ps 0.8 lt 1 title 'equal balls', 'plot.csv' index 1 using 1:2 with linespoints lw 2 pt 7 ps 0.8 lt 2 title 'big tenth ball'
