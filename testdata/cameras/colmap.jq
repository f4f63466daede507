# The scene of a picture of COLMAP, whose q and t lead from world to view.
# usage: jq -Rn --arg picture NAME -f colmap.jq cameras.txt images.txt
[inputs / " "] | ([.[] | select(.[9] == $picture)][0] //
  error("no picture \($picture)")) as $image |
($image[1:8] | map(tonumber)) as $q |
.[] | select(.[0] == $image[8] and (.[1] | test("^[A-Z]"))) |
.[1] as $model | .[2:] | map(tonumber) | {
  convention: "opencv", viewport: {width: .[0], height: .[1]},
  projection: {type: "persp", intrinsics: (
    if $model == "PINHOLE" then .[2:6]
    elif $model == "SIMPLE_PINHOLE" or $model == "SIMPLE_RADIAL" and .[5] == 0
    then [.[2], .[2], .[3], .[4]] else error("undistort \($model) first") end)},
  camera: {matrix: [{quaternion_wxyz: $q[:4]}, {translate: $q[4:]}]}
}
