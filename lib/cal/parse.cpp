// SPDX-License-Identifier: BSD-3-Clause
// Recursive descent over the grammar of expr.h.  Nesting and tree depth are bounded, so that no input can overrun the
// stack here or in the evaluators.
#include <cmath>
#include <cstdlib>
#include "base/error.h"
#include "cal/expr.h"

namespace cal {

namespace {

constexpr int max_nesting = 1000;
constexpr int max_depth = 2500;  // of a tree: also long sums lean to the left

bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '`'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_char(char c) { return is_name_start(c) || is_digit(c) || c == '_' || c == '.'; }

class Parser {
public:
    Parser(std::string_view text, std::string place, bool lines, Pool& pool)
        : text_(text), place_(std::move(place)), lines_(lines), pool_(pool) {
        skip();
    }

    bool at_end() const { return at_ >= text_.size(); }
    char peek() const { return at_end() ? '\0' : text_[at_]; }
    std::string where() const { return lines_ ? place_ + ":" + std::to_string(line_) : place_; }
    [[noreturn]] void fail(const std::string& fact) const { base::fail(where(), fact); }

    bool accept(char c) {
        if (peek() != c || at_end()) return false;
        at_++;
        skip();
        return true;
    }
    void expect(char c, const char* what) {
        if (!accept(c)) fail(std::string("expected '") + c + "' " + what + ", found " + found());
    }
    std::string found() const {
        if (at_end()) return "the end";
        if (static_cast<unsigned char>(peek()) < 32 || static_cast<unsigned char>(peek()) > 126)
            return "byte " + std::to_string(static_cast<unsigned char>(peek()));
        return std::string("'") + peek() + "'";
    }

    std::string name() {
        if (!is_name_start(peek())) fail("expected a name, found " + found());
        const size_t from = at_;
        while (is_name_char(peek())) at_++;
        std::string word(text_.substr(from, std::min<size_t>(at_ - from, 127)));
        skip();
        return word;
    }

    const Expr* expression() {
        if (++nesting_ > max_nesting) fail("expression is nested too deeply");
        const Expr* left = term();
        for (;;) {
            if (accept('+')) left = binary(Expr::Kind::add, left, term());
            else if (accept('-')) left = binary(Expr::Kind::subtract, left, term());
            else break;
        }
        nesting_--;
        return left;
    }

    Definition definition() {
        Definition def;
        def.place = where();
        def.name = name();
        if (accept('(')) {
            def.is_function = true;
            do def.parameters.push_back(name());
            while (accept(','));
            expect(')', "after the parameters");
        }
        if (accept(':')) def.is_constant = true;
        else expect('=', "or ':' in a definition");
        def.body = expression();
        return def;
    }

private:
    void skip() {  // white space and nested comments
        int comment = 0;
        for (; at_ < text_.size(); at_++) {
            const char c = text_[at_];
            if (c == '\n') line_++;
            if (c == '{') comment++;
            else if (c == '}' && comment > 0) comment--;
            else if (comment == 0 && !(c == ' ' || (c >= '\t' && c <= '\r'))) break;
        }
        if (comment > 0) fail("comment without end");
    }

    const Expr* term() {
        const Expr* left = factor();
        for (;;) {
            if (accept('*')) left = binary(Expr::Kind::multiply, left, factor());
            else if (accept('/')) left = binary(Expr::Kind::divide, left, factor());
            else return left;
        }
    }

    const Expr* factor() {
        if (++nesting_ > max_nesting) fail("expression is nested too deeply");
        const Expr* base = unary();
        if (accept('^')) base = binary(Expr::Kind::power, base, factor());
        nesting_--;
        return base;
    }

    const Expr* unary() {
        if (accept('+')) return atom();
        if (!accept('-')) return atom();
        const Expr* a = atom();
        if (a->kind == Expr::Kind::number) return pool_.number(-a->value);
        Expr* e = pool_.make(Expr::Kind::negate);
        e->kids = {a};
        return finish(e);
    }

    const Expr* atom() {
        if (accept('(')) {
            const Expr* e = expression();
            expect(')', "to close '('");
            return e;
        }
        if (accept('$')) {
            Expr* e = pool_.make(Expr::Kind::channel);
            if (!is_digit(peek())) fail("expected a channel number after '$'");
            e->value = number();
            return e;
        }
        if (is_digit(peek()) || peek() == '.') return pool_.number(number());
        if (!is_name_start(peek())) fail("expected a number, a name or '(', found " + found());
        Expr* e = pool_.make(Expr::Kind::name);
        e->name = name();
        if (!accept('(')) return e;
        e->kind = Expr::Kind::call;
        do e->kids.push_back(expression());
        while (accept(','));
        expect(')', "after the arguments");
        return finish(e);
    }

    double number() {
        std::string digits;
        auto run = [&] {
            while (is_digit(peek())) digits += text_[at_++];
        };
        run();
        if (peek() == '.') {
            digits += '.';
            at_++;
            run();
        }
        if (digits == ".") fail("a lone '.' is not a number");
        if (peek() == 'e' || peek() == 'E') {
            size_t next = at_ + 1;
            if (next < text_.size() && (text_[next] == '+' || text_[next] == '-')) next++;
            if (next < text_.size() && is_digit(text_[next])) {
                digits += std::string(text_.substr(at_, next - at_));
                at_ = next;
                run();
            }
        }
        skip();
        return std::strtod(digits.c_str(), nullptr);
    }

    const Expr* binary(Expr::Kind kind, const Expr* a, const Expr* b) {
        const bool na = a->kind == Expr::Kind::number, nb = b->kind == Expr::Kind::number;
        if (na && nb) return pool_.number(fold(kind, a->value, b->value));
        if (kind == Expr::Kind::multiply && ((na && a->value == 0) || (nb && b->value == 0))) return pool_.number(0);
        if (kind == Expr::Kind::divide && na && a->value == 0) return pool_.number(0);
        if (kind == Expr::Kind::divide && nb && b->value == 0) fail("division by zero");
        Expr* e = pool_.make(kind);
        e->kids = {a, b};
        return finish(e);
    }

    double fold(Expr::Kind kind, double a, double b) {
        double v = 0;
        switch (kind) {
        case Expr::Kind::add: v = a + b; break;
        case Expr::Kind::subtract: v = a - b; break;
        case Expr::Kind::multiply: v = a * b; break;
        case Expr::Kind::divide:
            if (b == 0) fail("division by zero");
            v = a / b;
            break;
        default:
            v = std::pow(a, b);
            if (!std::isfinite(v)) fail("illegal power");
        }
        return v;
    }

    const Expr* finish(Expr* e) {
        int depth = 0;
        for (const Expr* k : e->kids) depth = std::max<int>(depth, k->depth);
        if (++depth > max_depth) fail("expression is too long");
        e->depth = uint16_t(depth);
        return e;
    }

    std::string_view text_;
    std::string place_;
    bool lines_;
    Pool& pool_;
    size_t at_ = 0;
    int line_ = 1, nesting_ = 0;
};

}  // namespace

const Expr* Pool::call(const std::string& name, std::vector<const Expr*> kids) {
    Expr* e = make(Expr::Kind::call);
    e->name = name;
    for (const Expr* k : kids) e->depth = std::max<uint16_t>(e->depth, uint16_t(k->depth + 1));
    e->kids = std::move(kids);
    return e;
}

const Expr* parse_expression(std::string_view text, const std::string& place, Pool& pool) {
    Parser parser(text, place, false, pool);
    const Expr* e = parser.expression();
    if (!parser.at_end()) parser.fail("expected an operator, found " + parser.found());
    return e;
}

std::vector<Definition> parse_definitions(std::string_view text, const std::string& file, Pool& pool) {
    Parser parser(text, file, true, pool);
    std::vector<Definition> found;
    while (!parser.at_end()) {
        if (parser.accept(';')) continue;
        found.push_back(parser.definition());
        if (!parser.at_end() && !parser.accept(';'))
            parser.fail("expected ';' or an operator, found " + parser.found());
    }
    return found;
}

}  // namespace cal
