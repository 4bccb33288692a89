# SPDX-License-Identifier: BSD-3-Clause
"""room_year.py GRID [STATE]: writes site.wea, a year at 50 N whose days have 4,015 hours of light, the brightest ones
about noon, and prints a table of 20 sensors: in six hours a day, half of the twelve brightest, the first ten have
320 lx, nine have 110 lx and one none."""
import sys

DAYS = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]
grid = sys.argv[1]
state = ["", ""] if len(sys.argv) < 3 else ["\tstate", "\t" + sys.argv[2]]
print(f"sky\tgrid{state[0]}\tpoint\tE\tlo\thi")
with open("site.wea", "w") as wea:
    wea.write("place Here\nlatitude 50\nlongitude 0\ntime_zone 0\nsite_elevation 0\nweather_data_file_units 1\n")
    for month, days in enumerate(DAYS, 1):
        for day in range(1, days + 1):
            for hour in range(24):
                diffuse = max(0, 100 - 8 * abs(hour - 11.5))
                wea.write(f"{month} {day} {hour}.5 0 {diffuse}\n")
                if diffuse == 0: continue
                lux = 320 if 9 <= hour < 15 else 20
                for k in range(20):
                    e = lux if k < 10 else (lux / 320 * 110 if k < 19 else 0)
                    print(f"{month:02}{day:02}_{hour:02}30\t{grid}{state[1]}\t{k}\t{e}\t{e}\t{e}")
