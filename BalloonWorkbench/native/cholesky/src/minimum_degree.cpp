// SPDX-License-Identifier: LGPL-2.1-or-later
#include "minimum_degree.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace cholesky {
namespace {

using Word = std::uint64_t;

int bits_in(Word word) {
    word -= (word >> 1) & 0x5555555555555555u;
    word = (word & 0x3333333333333333u) + ((word >> 2) & 0x3333333333333333u);
    word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return static_cast<int>((word * 0x0101010101010101u) >> 56);
}

// The neighbours of each vertex as bits of whole words: eliminating one is a union of rows.
class BitGraph {
public:
    BitGraph(const Graph& graph, int inner)
        : words_((graph.size() + 63) / 64), bits_(static_cast<std::size_t>(inner) * words_, 0) {
        for (int v = 0; v < inner; ++v) {
            for (int u : Neighbours{graph, v})
                row(v)[u / 64] |= bit(u);
        }
    }
    int words() const { return words_; }
    Word* row(int v) { return &bits_[static_cast<std::size_t>(v) * words_]; }
    static Word bit(int v) { return Word{1} << (v % 64); }

    // Joins a row with another, without two vertices; the number of bits that are then set.
    int join(Word* into, const Word* from, int without, int nor) {
        for (int k = 0; k < words_; ++k)
            into[k] |= from[k];
        into[without / 64] &= ~bit(without);
        into[nor / 64] &= ~bit(nor);
        int count = 0;
        for (int k = 0; k < words_; ++k)
            count += bits_in(into[k]);
        return count;
    }

private:
    int words_;
    std::vector<Word> bits_;
};

} // namespace

std::vector<int> minimum_degree(const Graph& graph, int inner) {
    BitGraph bits(graph, inner);
    // among equal degrees the one whose neighbours changed last comes first, which gives less fill
    const int steps = inner + 1, gone = graph.size() * steps;
    std::vector<int> key(inner), order(inner);
    for (int v = 0; v < inner; ++v)
        key[v] = (graph.first[v + 1] - graph.first[v]) * steps;
    for (int step = 0; step < inner; ++step) {
        const int next = static_cast<int>(std::min_element(key.begin(), key.end()) - key.begin());
        order[step] = next;
        key[next] = gone;
        const Word* clique = bits.row(next);
        for (int word = 0; 64 * word < inner; ++word) {
            for (Word rest = clique[word]; rest != 0; rest &= rest - 1) {
                const int u = 64 * word + bits_in((rest & (~rest + 1)) - 1);
                if (u < inner)
                    key[u] = bits.join(bits.row(u), clique, next, u) * steps - step - 1;
            }
        }
    }
    return order;
}

} // namespace cholesky
