# An isolated building of one bay and two storeys, written by a newcomer. Units: kN, m, s, t.
model basic -ndm 3 -ndf 6
set L 6.0
set H 3.5
set E 30e6
proc tag {level column} { return [expr {10*$level + $column}] }
foreach {c x y} {1 0 0  2 6.0 0  3 6.0 6.0  4 0 6.0} {
    node [tag 0 $c] $x $y 0.0
    node [tag 1 $c] $x $y 0.3
    node [tag 2 $c] $x $y 3.8
    node [tag 3 $c] $x $y 7.3
}
node 5 1,5 0 0                             ;# 1: a comma for a point
node 11 0 0 0                              ;# 2: a tag that is taken
nod 6 0 0 0                                ;# 3: a misspelled command
node 7 0 0                                 ;# 4: a coordinate is missing
node 8 O 0 0                               ;# 5: the letter O
fix 01 1 1 1 1 1 1
fix 99 1 1 1 1 1 1                         ;# 6: no such node
fix 2 1 1 1 1 1                            ;# 7: a flag too few
fix 3 1 1 1 1 1 2                          ;# 8: a flag of 2
fix 4 1 1 1 1 1 1
mass 31 40 40 -40 0 0 0                    ;# 9: a negative mass
mass 32 40 40 40 0 0 0 0 0                 ;# 10: too many numbers
uniaxialMaterial Steel1 1 400e3 200e6 0.01 ;# 11: a misspelled kind
uniaxialMaterial Steel01 2 400e3 200e6     ;# 12: a number is missing
uniaxialMaterial Steel01 3 400e3 -200e6 0.01 ;# 13: a negative modulus
uniaxialMaterial Elastic 4 $Es             ;# 14: a variable without a value
uniaxialMaterial Elastic 5 1e4
uniaxialMaterial Elastic 5 1e6             ;# 15: a tag that is taken
section Elastic 1 $E 0.16 2e-3 2e-3        ;# 16: G and J are missing
section Elastik 2 $E 0.16 2e-3 2e-3 12e6 4e-3 ;# 17: a misspelled kind
geomTransf Linear 1 0 0 0                  ;# 18: no direction
geomTransf Linear 2 1 0 0
geomTransf Lineal 3 1 0 0                  ;# 20: a misspelled kind
geomTransf PDelta 4 1 0 0
geomTransf Linear 5 0 0 1
for {set c 1} {$c <= 4} {incr c} {
    element elasticBeamColumn [tag 1 $c] [tag 1 $c] [tag 2 $c] 0.16 $E 12e6 4e-3 2e-3 2e-3 4
    element elasticBeamColumn [tag 2 $c] [tag 2 $c] [tag 3 $c] 0.16 $E 12e6 4e-3 2e-3 2e-3 4
}
element elasticBeamColumn 41 31 32 0.12 $E 12e6 4e-3 2e-3 2e-3 7 ;# 21: no such transformation
element elasticBeamColumn 42 32 88 0.12 $E 12e6 4e-3 2e-3 2e-3 5 ;# 22: no such node
element elasticBeamColum 43 33 34 0.12 $E 12e6 4e-3 2e-3 2e-3 5  ;# 23: a misspelled kind
element elasticBeamColumn 44 34 31 0 $E 12e6 4e-3 2e-3 2e-3 5    ;# 24: no area
element elasticBeamColumn 45 31 31 0.12 $E 12e6 4e-3 2e-3 2e-3 5 ;# 25: both ends are one node
element elasticBeamColumn 11 21 22 0.12 $E 12e6 4e-3 2e-3 2e-3 5 ;# 26: a tag that is taken
element elasticBeamColumn 46 21 22 0.12 $E 12e6 4e-3 2e-3 2e-3 5 -mas 0.3 ;# 27: a misspelled option
element elastomericBearingBoucWen 1 1 11 2e3 50 0.1 0 2 1 0.5 0.5 -P 5 -T 5 -My 5 ;# 28: -Mz is missing
element elastomericBearingBoucWen 2 2 12 -2e3 50 0.1 0 2 1 0.5 0.5 -P 5 -T 5 -My 5 -Mz 5 ;# 29: a negative stiffness
element elastomericBearingBoucWen 3 3 13 2e3 50 0.1 0 2 1 0.5 0.5 -P 55 -T 5 -My 5 -Mz 5 ;# 30: no such material
element zeroLength 47 14 4 -mat 5 5 5 -dir 1 2 ;# 31: three materials for two directions
rigidDiaphragm 3 31 32 33 77               ;# 32: no such node
equalDOF 31 34 7                           ;# 33: a direction that the nodes do not have
timeSeries Linear 1
timeSeries Path 2 -dt 0.01 -filePath nowhere.txt ;# 34: no such file
pattern Plain 1 9 { load 31 1 0 0 0 0 0 }  ;# 35: no such series
pattern Plain 2 1 {
    load 31 0 0 -100 0 0                   ;# 36: a force is missing
    laod 32 0 0 -100 0 0 0                 ;# 37: a misspelled command
}
rayleigh 0.1 0.0 0.001                     ;# 38: a factor is missing
recorder Node -file roof.out -node 31 -dof 1 dips ;# 39: a misspelled response
recorder Element -file b.out -ele 3 forse  ;# 40: of an element that was rejected
analysis Statik                            ;# 19: a misspelled kind
