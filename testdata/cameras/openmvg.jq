# The scene of a picture in sfm_data.json of OpenMVG. R is by rows, from world to view.
# usage: jq --arg picture NAME -f openmvg.jq sfm_data.json
. as $sfm | [.views[].value.ptr_wrapper.data | select(.filename == $picture)][0] //
  error("no picture \($picture)") | . as $view |
([$sfm.extrinsics[] | select(.key == $view.id_pose).value][0] //
  error("no pose")) as $pose |
$sfm.intrinsics[] | select(.key == $view.id_intrinsic) | [.. | objects] | add |
if (.focal_length | not) or (keys | any(test("fisheye|prism"))) or
  ([del(.principal_point)[] | arrays[]] | any(. != 0)) then error("undistort first")
else {
  convention: "opencv", viewport: {width, height},
  projection: {type: "persp",
    intrinsics: ([.focal_length, .focal_length] + .principal_point)},
  camera: ($pose | {rotation, eye: .center})
} end
