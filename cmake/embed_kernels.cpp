// SPDX-License-Identifier: BSD-3-Clause
// embed_kernels ROOT FILE OUT.cpp SYMBOL: expands FILE's quoted includes below ROOT (each once), keeps #line, and
// writes the text as one C++ string, so that the OpenCL program travels inside the executable.
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>

static std::set<std::string> seen;

static void expand(const std::string& root, const std::string& name, std::ostream& out) {
    std::ifstream in(root + "/" + name);
    if (!in) {
        std::cerr << "embed_kernels: " << name << ": cannot be read\n";
        std::exit(1);
    }
    std::string line;
    int number = 0;
    out << "#line 1 \"" << name << "\"\n";
    while (std::getline(in, line)) {
        number++;
        const std::string key = "#include \"";
        if (line.compare(0, key.size(), key) != 0) {
            out << line << "\n";
            continue;
        }
        std::string file = line.substr(key.size(), line.find('"', key.size()) - key.size());
        if (!std::ifstream(root + "/" + file)) file = name.substr(0, name.rfind('/') + 1) + file;
        if (file.compare(0, 8, "kernels/") != 0 || !std::ifstream(root + "/" + file)) {
            out << "// host only: " << line << "\n";
            continue;
        }
        if (seen.insert(file).second) expand(root, file, out);
        out << "#line " << number + 1 << " \"" << name << "\"\n";
    }
}

int main(int argc, char** argv) {
    if (argc != 5) return 1;
    std::ostringstream text;
    expand(argv[1], argv[2], text);
    std::ofstream out(argv[3]);
    out << "namespace device { extern const char* const " << argv[4] << "; const char* const " << argv[4] << " =\n";
    std::istringstream lines(text.str());
    for (std::string line; std::getline(lines, line);) out << "R\"LUX(" << line << "\n)LUX\"\n";
    out << "; }\n";
    return out ? 0 : 1;
}
