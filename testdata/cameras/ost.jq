# The scene of the rectified picture of a camera_info.yaml or ost.yaml that the node
# camera_calibration of ROS writes.
# usage: jq -Rs -f ost.jq camera_info.yaml
def after(name): "\n" + . | split("\n" + name + ":")[1] // error("no " + name);
def number: match("[0-9]+").string | tonumber;
if "\n" + . | test("\nbinning_[xy]: *([2-9]|1[0-9])") then error("binning")
elif after("distortion_model") | test("^ *plumb_bob\\s") then {
  convention: "opencv",
  viewport: {width: after("image_width") | number,
    height: after("image_height") | number},
  projection: {type: "persp", intrinsics: (after("projection_matrix") |
    split("data:")[1] | split("]")[0] | [scan("[-+.0-9e]+") | tonumber])}
} else error("distortion_model") end
