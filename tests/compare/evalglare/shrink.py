# SPDX-License-Identifier: BSD-3-Clause
"""A picture and options that still differ, with as little in them as can be."""
from pictures import Picture


def shrink(picture, options, difference):
    """`difference(picture, options)` says what differs, or None."""
    options = without_options(picture, options, difference)
    for k in range(len(picture.lines) - 1, -1, -1):
        fewer = Picture(picture.width, picture.height, picture.lines[:k] + picture.lines[k + 1:], picture.pixels)
        if "VIEW=" not in picture.lines[k] and difference(fewer, options):
            picture = fewer
    picture = plain_blocks(picture, options, difference)
    return picture, without_options(picture, options, difference)


def without_options(picture, options, difference):
    k = 0
    while k < len(options):
        fewer = options[:k] + options[k + 1:]
        if difference(picture, fewer):
            options = fewer
        else:
            k += 1
    return options


def plain_blocks(picture, options, difference):
    """Blocks of pixels, ever smaller, become the commonest dark pixel as long as the difference stays."""
    plain = sorted(picture.pixels, key=lambda p: (p[3], p[1]))[len(picture.pixels) // 4]
    tries, size = 400, max(picture.width, picture.height)
    while size >= 1 and tries > 0:
        for top in range(0, picture.height, size):
            for left in range(0, picture.width, size):
                inside = [j * picture.width + i for j in range(top, min(top + size, picture.height))
                          for i in range(left, min(left + size, picture.width))]
                if tries <= 0 or all(picture.pixels[k] == plain for k in inside):
                    continue
                pixels = list(picture.pixels)
                for k in inside:
                    pixels[k] = plain
                tries -= 1
                simpler = Picture(picture.width, picture.height, picture.lines, pixels)
                if difference(simpler, options):
                    picture = simpler
        size //= 2
    return picture
