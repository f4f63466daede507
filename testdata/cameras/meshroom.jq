# The scene of a picture in cameras.sfm or sfm.json of Meshroom (AliceVision), whose
# numbers are strings. R is by columns, from world to view; principalPoint counts from
# the centre of the picture since version 1.2.5.
# usage: jq --arg picture NAME -f meshroom.jq sfm.json
. as $sfm | if (.version | map(tonumber)) < [1, 2, 5] then error("version before 1.2.5")
else [.views[] | select(.path | endswith("/" + $picture))][0] //
  error("no picture \($picture)") end | . as $view |
if .rigId then error("rigId")
else [$sfm.poses[] | select(.poseId == $view.poseId)][0] // error("no pose") end |
  .pose.transform | map_values(map(tonumber)) | . as $pose |
$sfm.intrinsics[] | select(.intrinsicId == $view.intrinsicId) |
if ("\(.type) \(.distortionType // "none")" |
    test("^(pinhole|radial\\d|brown) (none|radial|brown)") | not) or
  ([.distortionParams, .undistortionParams | arrays[] | tonumber] | any(. != 0))
then error("undistort first") else . end |
[.width, .height, .focalLength, .sensorWidth, .pixelRatio, .principalPoint[] |
  tonumber] as [$width, $height, $f, $sensor, $ratio, $cx, $cy] | {
  convention: "opencv", viewport: {$width, $height},
  projection: {type: "persp", intrinsics: [$f / $sensor * $width,
    $f / $sensor * $width * $ratio, $width / 2 + $cx, $height / 2 + $cy]},
  camera: {eye: $pose.center,
    rotation: ($pose.rotation | [.[0:3], .[3:6], .[6:]] | transpose)}
}
