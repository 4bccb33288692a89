# SPDX-License-Identifier: BSD-3-Clause
# CONTRIBUTING's recipe "Add a device", followed in a copy of the tree: `serial`, one thread of the baseline kernels,
# with a self-test at every start.
# Compiles the files that the recipe touches by the commands of the build, and links them into its bits_test.
. "${TOP:?}/tests/lib.sh"
build=${BIN%/bin}
needs ninja bits_test
[ -f "$build/build.ninja" ] || skip 'not a build of ninja'
mkdir tree
cp -r "$TOP/lib" "$TOP/man" tree
cp -r tree before
cd tree || exit 2

# 1. the device
cat > lib/device/serial_device.cpp << 'END'
// SPDX-License-Identifier: BSD-3-Clause
// The baseline kernels on one thread.
#include "device/cpu_kernels.h"
#include "device/scene_tables.h"

namespace kernels {
#include "kernels/cal/cal_noise.h"
#include "kernels/self_test.h"
}  // namespace kernels

namespace device {
namespace {

class SerialDevice : public Device {
public:
    std::string name() const override { return "serial"; }

    void upload(std::shared_ptr<const flatten::FlatScene> scene) override { scene_ = std::move(scene); }
    uint32_t preferred_batch_size() const override { return 4096; }

    void run(const Params& par, std::vector<float>& rgb) override {
        rgb.resize(size_t(kernels::film_places(&par)) * 3);
        tiles(par.path_count, [&](uint32_t first, uint32_t count, char* scratch) {
            float* film = par.reuse_path_count != 0 ? rgb.data() : &rgb[size_t(first) * 3];
            cpu_baseline.run(tables_of(*scene_, par), par, par.first + first, count, scratch, film);
        });
    }
    void splat(const Params& par, const std::vector<SplatRay>& rays, std::vector<float>& rgb) override {
        rgb.resize(rays.size() * 3);
        tiles(uint32_t(rays.size()), [&](uint32_t first, uint32_t count, char* scratch) {
            cpu_baseline.splat(tables_of(*scene_, par), par, rays.data(), first, count, scratch, rgb.data());
        });
    }
    void pilot(const Params& par, const std::vector<PilotRay>& rays, std::vector<PilotEnd>& ends) override {
        ends.resize(rays.size());
        tiles(uint32_t(rays.size()), [&](uint32_t first, uint32_t count, char* scratch) {
            cpu_baseline.pilot(tables_of(*scene_, par), par, rays.data(), first, count, scratch, ends.data());
        });
    }
    std::string identity() override { return "serial 1"; }
    std::vector<float> self_test_numbers(uint32_t n) override {
        std::vector<float> out(n);
        for (uint32_t i = 0; i < n; i++) out[i] = kernels::self_test_value(i / SELF_TEST_VALUES, i % SELF_TEST_VALUES);
        return out;
    }

private:
    template <class F>
    void tiles(uint32_t count, F&& work) {
        constexpr uint32_t tile = 4096;
        std::vector<char> scratch(cpu_baseline.scratch_bytes(tile));
        for (uint32_t first = 0; first < count; first += tile) {
            heed_wish();
            work(first, std::min(tile, count - first), scratch.data());
        }
    }

    std::shared_ptr<const flatten::FlatScene> scene_;
};

}  // namespace

std::unique_ptr<Device> make_serial_device() { return std::make_unique<SerialDevice>(); }

}  // namespace device
END
# 2. its declaration
sed -i '/^std::unique_ptr<Device> make_cpu_device/a std::unique_ptr<Device> make_serial_device();' lib/device/device.h
# 3. the file
sed -i 's|SOURCES cpu_device.cpp|& serial_device.cpp|' lib/device/CMakeLists.txt
# 4. its name
sed -i -e 's|^    if (kind == "cpu").*|&\n    if (kind == "serial") return tested(device::make_serial_device(), "");|' \
    -e 's|^    for (auto& d : device::opencl_devices.*|    out.push_back(device::make_serial_device()->name());\n&|' \
    lib/render/make_device.cpp
# 5. the page
sed -i 's|^\.B opencl:NAME$|.B serial\none thread of the processor,\n&|' man/ptrace.1

recipe() { sed -n '/^## Add a device/,/^Then its/s/^[0-9]\. `\([a-z]*\/[^`]*\)`.*/\1/p' "$TOP/CONTRIBUTING.md"; }
cd ..
check 'the files that were touched are those of the recipe, and no others' '
    { diff -rq before tree || true; } | sed -E "s|^Only in tree/(.*): |\1/|; s|^Files before/(.*) and .*|\1|" |
        sort > touched
    recipe | sed "s/NAME/serial/" | sort | diff - touched'

# The build's own commands, with the sources of the copy.  compile FILE AS: as the build compiles the file AS.
build_commands "$build" bits_test > commands
compile() {
    sed -n "s|^[^ ]*ccache ||; s| -MD -MT [^ ]* -MF [^ ]*||; s| -o [^ ]*| -o $PWD/$(basename "$1").o|
        s|$TOP/lib|$PWD/tree/lib|g; s|$2|$1|g; \| -c .*$1\$|p" commands | tail -1 > command
    (cd "$build" && bash -e "$TMP/command")
}
check 'its files compile' '
    compile device/serial_device.cpp device/cpu_device.cpp
    compile render/make_device.cpp render/make_device.cpp'
check 'a program links with them' '
    objects="$PWD/serial_device.cpp.o $PWD/make_device.cpp.o"
    tail -1 commands | sed "s| -o bin/bits_test | $objects -Wl,-z,muldefs -o $PWD/bits |" > command
    (cd "$build" && bash -e "$TMP/command")'
check 'its frames are those of the processor, bit by bit' '
    ./bits serial gallery_east many_lamps every > said && grep -q "3 rows on serial, 0 moved" said'
check_error 'another name is not known' 1 "^bits_test: -device: \"parallel\" is not" './bits parallel many_lamps'
