// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The unit of the measurements: one supernodal Cholesky factorisation by CHOLMOD with OpenBLAS on one thread,
// in the order of AMD or METIS that has the fewest operations.
//
// yardstick FILE... reads matrices in the format of speed/tangent.py and prints a line of JSON for each.
// Where a file goes on with the vertex of each unknown (int32), the number of vertices (int32) and their
// places in the plane (float64, x y x y ...), it times the solver's own factorisation of the same matrix as
// well, and before all else measures its memory: growth to the peak for analysis, factor and solution on as
// many threads as the solver takes.
#include <cblas.h>
#include <cholmod.h>
#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "cholesky/cholesky.h"
#include "stopwatch.h"

namespace {

struct Matrix {
    std::vector<std::int64_t> starts;
    std::vector<std::int32_t> rows;
    std::vector<double> values;
    cholesky::Blocks blocks; // none when the file does not tell

    explicit Matrix(const char* path) {
        std::ifstream file(path, std::ios::binary);
        const std::vector<std::int64_t> sizes = numbers<std::int64_t>(file, 2);
        starts = numbers<std::int64_t>(file, sizes[0] + 1);
        rows = numbers<std::int32_t>(file, sizes[1]);
        values = numbers<double>(file, sizes[1]);
        if (!file)
            throw std::runtime_error(std::string(path) + " holds no matrix");
        if (file.peek() == std::ifstream::traits_type::eof())
            return;
        blocks.block_of_unknown = numbers<std::int32_t>(file, sizes[0]);
        const std::int64_t count = numbers<std::int32_t>(file, 1)[0];
        const std::vector<double> places = numbers<double>(file, 2 * count);
        if (!file)
            throw std::runtime_error(std::string(path) + " ends amid the vertices");
        for (size_t k = 0; k < places.size(); k += 2)
            blocks.points.push_back({places[k], places[k + 1]});
    }
    size_t count() const { return starts.size() - 1; }

private:
    template <typename T>
    static std::vector<T> numbers(std::ifstream& file, std::int64_t count) {
        std::vector<T> result(file ? count : 2);
        file.read(reinterpret_cast<char*>(result.data()),
                  static_cast<std::streamsize>(result.size() * sizeof(T)));
        return result;
    }
};

cholesky::Pattern pattern_of(const Matrix& matrix) {
    return {{matrix.starts.begin(), matrix.starts.end()}, matrix.rows};
}

// A line of /proc/self/status, in bytes.
long long status(const std::string& name) {
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;) {
        long long kilobytes = 0;
        if (word == name + ":" && file >> kilobytes)
            return 1024 * kilobytes;
    }
    throw std::runtime_error("/proc/self/status has no " + name);
}

// How much memory this process needs for our factorisation, from the analysis on.
long long peak_of_ours(const Matrix& matrix) {
    cholesky::Pattern pattern = pattern_of(matrix);
    std::vector<double> right(matrix.count(), 1.0);
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5; // forgets the peak
    const long long before = status("VmRSS");
    cholesky::Factorisation ours(std::move(pattern), matrix.blocks, cholesky::default_threads());
    ours.factorise_and_solve(matrix.values.data(), nullptr, right.data());
    return status("VmHWM") - before;
}

// Operations a second of OpenBLAS in a product of two dense matrices.
double fastest() {
    constexpr int kSize = 1000;
    const std::vector<double> a(kSize * kSize, 0.5), b(kSize * kSize, 0.25);
    std::vector<double> c(kSize * kSize);
    const double seconds = median_processor_seconds([&] {
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, kSize, kSize, kSize, 1.0, a.data(), kSize,
                    b.data(), kSize, 0.0, c.data(), kSize);
    });
    return 2.0 * kSize * kSize * kSize / seconds;
}

// CHOLMOD's work on a matrix, in seconds.
void time_cholmod(const Matrix& matrix) {
    std::vector<SuiteSparse_long> starts(matrix.starts.begin(), matrix.starts.end());
    std::vector<SuiteSparse_long> rows(matrix.rows.begin(), matrix.rows.end());
    std::vector<double> values = matrix.values;
    cholmod_sparse lower{};
    lower.nrow = lower.ncol = matrix.count();
    lower.nzmax = values.size();
    lower.p = starts.data();
    lower.i = rows.data();
    lower.x = values.data();
    lower.stype = -1;
    lower.itype = CHOLMOD_LONG;
    lower.xtype = CHOLMOD_REAL;
    lower.dtype = CHOLMOD_DOUBLE;
    lower.sorted = lower.packed = 1;

    cholmod_common common;
    cholmod_l_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 2;
    common.method[0].ordering = CHOLMOD_AMD;
    common.method[1].ordering = CHOLMOD_METIS;
    cholmod_factor* factor = nullptr;
    const double analyse = processor_seconds([&] { factor = cholmod_l_analyze(&lower, &common); });
    const double entries = common.lnz, flops = common.fl;
    const double factorise = median_processor_seconds([&] { cholmod_l_factorize(&lower, factor, &common); });
    const bool definite = factor->minor == matrix.count();
    cholmod_dense* right = cholmod_l_ones(matrix.count(), 1, CHOLMOD_REAL, &common);
    cholmod_dense *solution = nullptr, *work = nullptr, *more = nullptr;
    const double solve = median_processor_seconds([&] {
        cholmod_l_solve2(CHOLMOD_A, factor, right, nullptr, &solution, nullptr, &work, &more, &common);
    });
    std::printf(
        "\"definite\": %s, \"factor_seconds\": %.6g, \"analyse_seconds\": %.6g, \"solve_seconds\": %.6g, "
        "\"factor_entries\": %.6g, \"flops\": %.6g",
        definite ? "true" : "false", factorise, analyse, solve, entries, flops);
    for (cholmod_dense* vector : {right, solution, work, more})
        cholmod_l_free_dense(&vector, &common);
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_finish(&common);
}

// The solver's own: on one thread, and on two by the clock.
void time_ours(const Matrix& matrix, long long peak) {
    const cholesky::Pattern pattern = pattern_of(matrix);
    const double* const values = matrix.values.data();
    const double analyse = processor_seconds([&] { cholesky::Factorisation(pattern, matrix.blocks, 1); });
    cholesky::Factorisation alone(pattern, matrix.blocks, 1), both(pattern, matrix.blocks, 2);
    std::vector<double> right(matrix.count());
    const double factorise = median_processor_seconds([&] { alone.factorise(values, nullptr); });
    const double together = median_processor_seconds([&] {
        std::fill(right.begin(), right.end(), 1.0);
        alone.factorise_and_solve(values, nullptr, right.data());
    });
    const double solve = median_processor_seconds([&] {
        std::fill(right.begin(), right.end(), 1.0);
        alone.solve(right.data());
    });
    const double shared = median_clock_seconds([&] { both.factorise(values, nullptr); });
    std::printf(", \"ours\": {\"analyse_seconds\": %.6g, \"factor_seconds\": %.6g, \"solve_seconds\": %.6g, "
                "\"factor_and_solve_seconds\": %.6g, \"two_threads_clock_seconds\": %.6g, "
                "\"factor_entries\": %zu, \"peak_bytes\": %lld}",
                analyse, factorise, solve, together, shared, alone.factor_entries(), peak);
}

} // namespace

int main(int count, char** paths) {
    openblas_set_num_threads(1);
    try {
        for (int k = 1; k < count; ++k) {
            const Matrix matrix(paths[k]);
            std::printf("{\"file\": \"%s\", \"unknowns\": %zu, ", paths[k], matrix.count());
            const bool ours = !matrix.blocks.points.empty();
            // first, while nothing else has used memory
            const long long peak = ours ? peak_of_ours(matrix) : 0;
            time_cholmod(matrix);
            if (ours)
                time_ours(matrix, peak);
            std::printf(", \"fastest\": %.6g}\n", fastest());
            std::fflush(stdout);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
