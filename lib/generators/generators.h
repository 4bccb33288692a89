// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE's scene generators, built in: "!genbox ..." runs no program.  Each writes scene text with RADIANCE's own
// geometry, names and 12 digits, and goes through the ordinary reader, so that both give the same scene.
// To add one: a file for it, a line here, a row in generators.cpp.
#pragma once
#include <string>
#include <vector>
#include "base/vec.h"
#include "base/find_file.h"

namespace generators {

struct Call {
    std::vector<std::string> words;  // words[0] is the name
    std::string input;               // the file on standard input; "" if there is none
    std::string place;               // "file:line"
    const base::ReadOptions& options;
    long long most = 1000000;                               // pieces it may write
    [[noreturn]] void fail(const std::string& fact) const;  // "place: genbox: fact"
    bool has(size_t i) const { return i < words.size(); }
    const std::string& word(size_t i, const char* what) const;
    double real(size_t i, const char* what) const;
    long long integer(size_t i, const char* what, long long low, long long high) const;
};
using Generator = void (*)(const Call& call, std::string& out);

void genbox(const Call& call, std::string& out);
void genblinds(const Call& call, std::string& out);
void genciesky(const Call& call, std::string& out);
void gendaylit(const Call& call, std::string& out);
void genprism(const Call& call, std::string& out);
void genrev(const Call& call, std::string& out);
void gensky(const Call& call, std::string& out);
void gensurf(const Call& call, std::string& out);
void genworm(const Call& call, std::string& out);

// The generator of this name; null if it is none of ours.
Generator find(const std::string& name);

// Pieces of scene text.
std::string number(double v);                 // 12 significant digits
std::string quoted(const std::string& word);  // with quotes if it needs them to be one word
void write_surface(std::string& out, const std::string& material, const char* type, const std::string& name,
                   const std::vector<double>& reals);
void write_polygon(std::string& out, const std::string& material, const std::string& name,
                   const std::vector<base::Vec3>& v);

}  // namespace generators
