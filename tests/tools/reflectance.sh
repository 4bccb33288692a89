# SPDX-License-Identifier: BSD-3-Clause
# Materials that give back more light than they get are told of, with file, line and value, and refused where no
# measurement errs so far; what may be large is not.
. "${TOP:?}/tests/lib.sh"
needs ptrace
echo 'void glow sky 0 0 4 1 1 1 0  sky source dome 0 0 4 0 0 1 360' > sky.rad

# scene 'material w': a ball of it under a sky of 1.
scene() { printf '# a ball\n%s\nw sphere ball 0 0 4 0 4 0 1\n' "$1" > w.rad; }
render() { ptrace -frames 1 -x 8 -y 8 "$@" w.rad sky.rad 2>&1 > /dev/null; }
silent() { scene "$1"; render > said; test ! -s said || { cat said; false; }; }
warned() { scene "$1"; render > said; grep -q -x "ptrace: warning: w.rad:2: $2" said || { cat said; false; }; }
refused() {
    scene "$1"
    ! render > said || return 1
    grep -q "^ptrace: w.rad:2: $2 times the light that it gets" said || { cat said; return 1; }
    render -any-reflectance > said && test "$(wc -l < said)" -le 1 && ! grep -q -v warning said
}

check 'a percentage, 0 to 255, 2 are refused, unless -any-reflectance' '
    refused "void plastic w 0 0 5 70 70 70 0 0" "plastic \"w\": gives back 70"
    refused "void metal w 0 0 5 .1 200 .1 .9 0" "metal \"w\": gives back 200"
    refused "void glass w 0 0 3 88 88 88" "glass \"w\": gives back 88"
    refused "void mirror w 0 0 3 90 90 90" "mirror \"w\": gives back 90"
    refused "void plastic w 0 0 5 2 2 2 0 0" "plastic \"w\": gives back 2"
    refused "void plastic w 0 0 5 .5 .5 .5 5 0" "plastic \"w\": gives back 7"
    refused "void trans w 0 0 7 50 50 50 0 0 .5 0" "trans \"w\": gives back 50"'
check 'diffuse, specular and transmitted parts are summed' '
    refused "void ashik2 w 4 0 0 1 . 0 8 .9 .9 .9 1.1 1.1 1.1 10 10" "ashik2 \"w\": gives back 2"
    refused "void BRTDfunc w 10 0 0 0 0 0 0 0 0 0 . 0 9 .9 .9 .9 .1 .1 .1 1.2 .1 .1" "BRTDfunc \"w\": gives back 2.1"
    warned "void BRTDfunc w 10 0 0 0 0 0 0 0 0 0 . 0 9 .5 .5 .5 .1 .1 .1 .6 .1 .1" \
        "BRTDfunc \"w\": gives back 1.1 times the light that it gets"'
check 'above 1, below 0: file, line and value' '
    warned "void plastic w 0 0 5 1.5 .5 .5 0 0" "plastic \"w\": reflectance 1.5 is above 1"
    warned "void plastic w 0 0 5 .5 -.25 .5 0 0" "plastic \"w\": reflectance -0.25 is below 0"
    warned "void plastic w 0 0 5 .5 .5 .5 1.2 0" "plastic \"w\": specularity 1.2 is above 1"
    warned "void plastic w 0 0 5 .5 .5 .5 .02 -.1" "plastic \"w\": roughness -0.1 is below 0"
    warned "void plastic2 w 4 0 0 1 . 0 6 .5 .5 .5 .02 .1 -.3" "plastic2 \"w\": roughness -0.3 is below 0"
    warned "void trans w 0 0 7 .5 .5 .5 0 0 1.3 0" "trans \"w\": transmittance 1.3 is above 1"
    warned "void glass w 0 0 3 1.1 .9 .9" "glass \"w\": transmissivity 1.1 is above 1"
    warned "void dielectric w 0 0 5 .9 1.4 .9 1.5 0" "dielectric \"w\": transmissivity 1.4 is above 1"'
check 'one line for a material of many surfaces' '
    scene "void plastic w 0 0 5 1.5 .5 .5 0 0"; echo "w sphere b 0 0 4 3 4 0 1" >> w.rad; render > said
    test $(wc -l < said) -eq 1'
check 'radiance may be large, and so may what functions give' '
    silent "void light w 0 0 3 5000 5000 5000"
    silent "void glow w 0 0 4 5000 5000 5000 0"
    silent "void spotlight w 0 0 7 5000 5000 5000 30 0 0 -1"
    silent "void illum w 0 0 3 5000 5000 5000"
    echo "dim(x,y,z) = 1/30;" > dim.cal; silent "void metfunc w 2 dim dim.cal 0 4 30 30 30 1"
    silent "void BRTDfunc w 10 0 0 0 0 0 0 0 0 0 . 0 12 .5 .5 .5 .1 .1 .1 .2 .1 .1 70 80 90"
    silent "void mist w 0 0 3 40 40 40"'
check 'a pattern above may bring it down' '
    silent "void brightfunc dark 2 .01 . 0 0  dark plastic w 0 0 5 50 50 50 0 0"
    silent "void brightfunc dark 2 .01 . 0 0  void texfunc t 4 .1 0 0 . 0 0  t alias dirt dark
        dark texfunc rough 4 .1 0 0 . 0 0 rough plastic w 0 0 5 50 50 50 0 0"
    refused "void texfunc rough 4 .1 0 0 . 0 0  rough plastic w 0 0 5 50 50 50 0 0" "plastic \"w\": gives back 50"'
check 'full white is fine, also where rounding adds to it' '
    silent "void plastic w 0 0 5 1 1 1 .05 .1"
    silent "void trans w 0 0 7 1 1 1 .1 .05 .7 .3"
    silent "void BRTDfunc w 10 0 0 0 0 0 0 0 0 0 . 0 9 .7 .7 .7 .1 .1 .1 .3 .3 .3"'
check 'materials that no surface has are not looked at' '
    scene "void plastic other 0 0 5 70 70 70 0 0  void plastic w 0 0 5 .5 .5 .5 0 0"; render > said; test ! -s said'
check 'regions may be drawn of such a scene' '
    needs vcregion; scene "void plastic w 0 0 5 70 70 70 0 0"; echo "ball surface ball" > r.txt
    vcregion -x 8 -y 8 -o r.exr r.txt w.rad; test -s r.exr'
