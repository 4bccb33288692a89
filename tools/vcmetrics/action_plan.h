// SPDX-License-Identifier: BSD-3-Clause
// What a run measures in pictures of actions (ACTION=), beside what it measures in ordinary ones: the columns of
// glare/actions.h, which stand behind the others.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "glare/columns.h"
#include "image/picture.h"
#include "options.h"

struct ActionPlan {
    struct Kind {          // pictures of one action
        std::string name;  // of its illuminance (glare::illuminance_of)
        glare::SharedPlan measured;
        std::vector<glare::Column> columns;
    };
    // A printed column: one of a kind's, or its ratio to the illuminance by V.
    struct Cell {
        glare::Column column;
        size_t kind = 0, place = 0;
        bool ratio = false;
    };
    std::vector<Kind> kinds;
    std::vector<Cell> cells;
    Cell by_V;  // its illuminance; with a ratio

    bool empty() const { return cells.empty(); }
    bool has_ratio() const;
    std::optional<size_t> kind_of(const image::Header& header) const;  // none: nothing is measured in it
};

// Which of -metrics and -until are such columns, and the others.
struct SplitNames {
    std::vector<std::string> ordinary, of_actions;
};
SplitNames split_names(const std::vector<std::string>& names);

// Of a picture of an action by itself: its illuminance; of V those of ordinary ones.
std::vector<std::string> default_columns_of(const image::Action& action);

// Throws Error (place) for a picture of an action among others, or the other way round: both are compared with their
// like.  illuminance: "mEDI" for pictures of mel; empty: for ordinary ones.
void require_pictures_of(const std::string& illuminance, const image::Header& header, const std::string& place);

// Of such names; ordinary, choice: of the other pictures.
ActionPlan plan_actions(const std::vector<std::string>& names, const glare::Plan& ordinary,
                        const glare::ColumnChoice& choice);
