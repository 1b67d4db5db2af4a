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
node 5 1,5 0 0                             ;# 1: a comma for a point `1,5`
node 11 0 0 0                              ;# 2: a tag that is taken `11`
nod 6 0 0 0                                ;# 3: a misspelled command `nod`
node 7 0 0                                 ;# 4: a coordinate is missing `node`
node 8 O 0 0                               ;# 5: the letter O `O`
fix 01 1 1 1 1 1 1
fix 99 1 1 1 1 1 1                         ;# 6: no such node `99`
fix 2 1 1 1 1 1                            ;# 7: a flag too few `fix`
fix 3 1 1 1 1 1 2                          ;# 8: a flag of 2 `2`
fix 4 1 1 1 1 1 1
mass 31 40 40 -40 0 0 0                    ;# 9: a negative mass `-40`
mass 32 40 40 40 0 0 0 0 0                 ;# 10: too many numbers `0`
uniaxialMaterial Steel1 1 400e3 200e6 0.01 ;# 11: a misspelled kind `Steel1`
uniaxialMaterial Steel01 2 400e3 200e6     ;# 12: a number is missing `uniaxialMaterial`
uniaxialMaterial Steel01 3 400e3 -200e6 0.01 ;# 13: a negative modulus `-200e6`
uniaxialMaterial Elastic 4 $Es             ;# 14: a variable without a value `$Es`
uniaxialMaterial Elastic 5 1e4
uniaxialMaterial Elastic 5 1e6             ;# 15: a tag that is taken `5`
section Elastic 1 $E 0.16 2e-3 2e-3        ;# 16: G and J are missing `section`
section Elastik 2 $E 0.16 2e-3 2e-3 12e6 4e-3 ;# 17: a misspelled kind `Elastik`
geomTransf Linear 1 0 0 0                  ;# 18: no direction `0`
geomTransf Linear 2 1 0 0
geomTransf Lineal 3 1 0 0                  ;# 20: a misspelled kind `Lineal`
geomTransf PDelta 4 1 0 0
geomTransf Linear 5 0 0 1
for {set c 1} {$c <= 4} {incr c} {
    element elasticBeamColumn [tag 1 $c] [tag 1 $c] [tag 2 $c] 0.16 $E 12e6 4e-3 2e-3 2e-3 4
    element elasticBeamColumn [tag 2 $c] [tag 2 $c] [tag 3 $c] 0.16 $E 12e6 4e-3 2e-3 2e-3 4
}
element elasticBeamColumn 41 31 32 0.12 $E 12e6 4e-3 2e-3 2e-3 7 ;# 21: no such transformation `7`
element elasticBeamColumn 42 32 88 0.12 $E 12e6 4e-3 2e-3 2e-3 5 ;# 22: no such node `88`
element elasticBeamColum 43 33 34 0.12 $E 12e6 4e-3 2e-3 2e-3 5  ;# 23: a misspelled kind `elasticBeamColum`
element elasticBeamColumn 44 34 31 0 $E 12e6 4e-3 2e-3 2e-3 5    ;# 24: no area `0`
element elasticBeamColumn 45 31 31 0.12 $E 12e6 4e-3 2e-3 2e-3 5 ;# 25: both ends are one node `31`
element elasticBeamColumn 11 21 22 0.12 $E 12e6 4e-3 2e-3 2e-3 5 ;# 26: a tag that is taken `11`
element elasticBeamColumn 46 21 22 0.12 $E 12e6 4e-3 2e-3 2e-3 5 -mas 0.3 ;# 27: a misspelled option `-mas`
element elastomericBearingBoucWen 1 1 11 2e3 50 0.1 0 2 1 0.5 0.5 -P 5 -T 5 -My 5 ;# 28: -Mz is missing `element`
element elastomericBearingBoucWen 2 2 12 -2e3 50 0.1 0 2 1 0.5 0.5 -P 5 -T 5 -My 5 -Mz 5 ;# 29: a negative stiffness `-2e3`
element elastomericBearingBoucWen 3 3 13 2e3 50 0.1 0 2 1 0.5 0.5 -P 55 -T 5 -My 5 -Mz 5 ;# 30: no such material `55`
element zeroLength 47 14 4 -mat 5 5 5 -dir 1 2 ;# 31: three materials for two directions `2`
rigidDiaphragm 3 31 32 33 77               ;# 32: no such node `77`
equalDOF 31 34 7                           ;# 33: a direction that the nodes do not have `7`
timeSeries Linear 1
timeSeries Path 2 -dt 0.01 -filePath nowhere.txt ;# 34: no such file `nowhere.txt`
pattern Plain 1 9 { load 31 1 0 0 0 0 0 }  ;# 35: no such series `9`
pattern Plain 2 1 {
    load 31 0 0 -100 0 0                   ;# 36: a force is missing `load`
    laod 32 0 0 -100 0 0 0                 ;# 37: a misspelled command `laod`
}
rayleigh 0.1 0.0 0.001                     ;# 38: a factor is missing `rayleigh`
recorder Node -file roof.out -node 31 -dof 1 dips ;# 39: a misspelled response `dips`
recorder Element -file b.out -ele 3 forse  ;# 40: of an element that was rejected `forse`
analysis Statik                            ;# 19: a misspelled kind `Statik`
