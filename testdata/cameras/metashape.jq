# The scene of a camera in the XML that Metashape exports, for points of its chunk.
# transform is by rows, from the camera, x right, y down, z forward, to the chunk.
# usage: jq -Rs --arg name LABEL -f metashape.jq cameras.xml
def find(re): [capture(re).n][0];
def number($tag): find("<" + $tag + ">(?<n>[^<]+)") // 0 | tonumber;
def quoted($what): find($what + "=\"(?<n>[^\"]+)\"");
([split("<camera ")[] | select(quoted("label") == $name)][0] //
  error("no camera " + $name)) as $camera |
[$camera | find("<transform>(?<n>[^<]+)") // error("not aligned") | scan("\\S+") |
  tonumber] as $m |
split("<sensor id=\"" + ($camera | quoted("sensor_id")) + "\"")[1] |
split("</sensor>")[0] |
if test("^[^>]* type=\"frame\"") | not then error("not a frame")
else split("class=\"adjusted\"")[1] // error("not adjusted") end |
if [number("k1", "k2", "k3", "k4", "p1", "p2", "p3", "p4")] | any(. != 0)
then error("undistort first") else . end |
[quoted("width", "height") | tonumber] as [$width, $height] | {
  convention: "opencv", viewport: {$width, $height},
  projection: {type: "persp", intrinsics: [
    [number("f") + number("b1"), number("b2"), $width / 2 + number("cx")],
    [0, number("f"), $height / 2 + number("cy")], [0, 0, 1]]},
  camera: {pose: [$m[0:4], $m[4:8], $m[8:12]]}
}
