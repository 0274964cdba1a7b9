text {
  ttf "none.ttf" "Hello" 1, 0
}
height_field {
  png "none.png"
}
sphere { 0, 1
  pigment { image_map { png "none.png" } } }
