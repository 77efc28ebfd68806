// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace film {

// Threads of all solves that begin from now on; 0: as many as find work.
void set_threads(int count);

// Threads for a mesh of so many vertices.
int threads_for(int vertices);

} // namespace film
