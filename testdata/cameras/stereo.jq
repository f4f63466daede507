# The scene of the left rectified picture of a pair, whose device z is the disparity,
# from a CameraInfo of ROS of each camera. The fourth number of P of the right one is
# -f b.
# usage: jq -s -f stereo.jq left.json right.json
map(.p // .P) as [$l, $r] |
if any(.[] | .binning_x, .binning_y; (. // 0) > 1) then error("binning")
elif any(.[]; [.roi // {} | .x_offset, .y_offset, .width, .height | . // 0] as $roi |
  $roi != [0,0,0,0] and $roi != [0,0,.width,.height]) then error("roi")
elif any(.[]; .distortion_model != "plumb_bob") then error("distortion_model")
elif $l[2] != $r[2] then error("cx of the cameras differ")
elif $l[0:3] + $l[4:] != $r[0:3] + $r[4:] or $l[3] != 0 or $r[3] >= 0
then error("not the left and the right camera of a pair")
else {
  convention: "opencv", viewport: (.[0] | {width, height, max_z: -$r[3]}),
  projection: {type: "persp", intrinsics: $l}
} end
