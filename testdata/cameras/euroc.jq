# The scene of a camera of EuRoC at a time, from its sensor.yaml and the ground truth's
# data.csv. T_BS is by rows, from the camera to the body; p and q, which is w x y z,
# lead on to the world. _lens has the coefficients for lens.awk.
# usage: jq -Rs --arg time NANOSECONDS -f euroc.jq sensor.yaml data.csv
def list($name): split("\n" + $name + ":")[1] | split("[")[1] | split("]")[0] |
  [scan("[-+.0-9e]+") | tonumber];
if test("\ncamera_model: pinhole\\s") | not then error("camera_model")
elif test("\ndistortion_model: radial-tangential\\s") | not
then error("distortion_model")
elif list("distortion_coefficients") | length != 4 then error("not 4 coefficients")
else . end |
([split("\n")[] | select(startswith($time + ","))][0] // error("no such time") |
  split(",")[:8] | map(tonumber)) as $truth |
list("T_BS") as $m | list("resolution") as [$width, $height] | {
  convention: "opencv", viewport: {$width, $height},
  projection: {type: "persp", intrinsics: list("intrinsics")},
  camera: {pose: [{matrix: [$m[0:4], $m[4:8], $m[8:12]]},
    {quaternion_wxyz: $truth[4:8]}, {translate: $truth[1:4]}]},
  _lens: list("distortion_coefficients")
}
