"""Draws the AVIF pictures of tests/e2e/pictures, which the browser decodes and the page's module does not.

Made with Pillow 13.0.0: pip install pillow==13.0.0; python foreign_pictures.py
"""

from pathlib import Path

from PIL import Image, ImageDraw, ImageFilter

FOLDER = Path(__file__).parents[1] / "e2e" / "pictures"
SIZE_PX = (160, 200)
# Antialiasing: the picture is drawn larger and scaled down.
OVERSAMPLING = 4
SKIN, SHADE, HAIR, LIPS, WHITE, BLACK = "#e0ac8c", "#cd9678", "#3c281e", "#b45050", "#f5f0eb", "#0a0a0a"


def drawn_face():
    """An upright, invented face."""
    picture = Image.new("RGB", [OVERSAMPLING * side for side in SIZE_PX], "#96aabe")
    draw = ImageDraw.Draw(picture)

    def px(numbers):
        return [OVERSAMPLING * number for number in numbers]

    def ellipse(box, colour):
        draw.ellipse(px(box), fill=colour)

    ellipse((25, 12, 135, 190), HAIR)
    draw.rectangle(px((62, 150, 98, 200)), fill=SHADE)
    ellipse((35, 30, 125, 180), SKIN)
    ellipse((35, 30, 125, 60), HAIR)
    for x in (60, 100):
        ellipse((x - 13, 88, x + 13, 104), SHADE)
        ellipse((x - 11, 90, x + 11, 102), WHITE)
        ellipse((x - 6, 90, x + 6, 102), HAIR)
        ellipse((x - 3, 93, x + 3, 99), BLACK)
        draw.arc(px((x - 15, 76, x + 15, 96)), 200, 340, fill=HAIR, width=4 * OVERSAMPLING)
    draw.polygon(px((80, 95, 72, 128, 88, 128)), fill=SHADE)
    ellipse((70, 120, 90, 134), SHADE)
    for x in (72, 82):
        ellipse((x, 127, x + 6, 132), LIPS)
    ellipse((60, 143, 100, 160), LIPS)
    draw.line(px((60, 151, 100, 151)), fill=HAIR, width=2 * OVERSAMPLING)
    return picture.filter(ImageFilter.GaussianBlur(5)).resize(SIZE_PX, Image.LANCZOS)


def main():
    turned = Image.Exif()
    turned[0x0112] = 6
    lying = drawn_face().rotate(90, expand=True)
    lying.save(FOLDER / "drawn-face.avif", quality=45, speed=0, exif=turned)
    # 50.4 megapixels.
    Image.new("RGB", (8200, 6150), "#78828c").save(FOLDER / "enormous.avif", quality=1, speed=10)


if __name__ == "__main__":
    main()
