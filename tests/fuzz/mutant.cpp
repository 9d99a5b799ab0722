// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/mutant.hpp"

namespace dem::fuzz {

std::string mutant(std::string bytes, Random& random) {
    const std::string letters = "0123456789.-+e /#=,\"\\\n\r\tvf\xff";
    const auto below = [&random](std::size_t n) {
        return static_cast<std::size_t>(random.next() % n);
    };
    for (std::size_t k = 1 + below(5); k-- > 0;) {
        if (bytes.empty()) bytes = "0";
        const std::size_t at = below(bytes.size());
        switch (below(5)) {
            case 0:
                bytes[at] = static_cast<char>(random.next());
                break;
            case 1:
                bytes[at] = letters[below(letters.size())];
                break;
            case 2:
                bytes.insert(at, 1 + below(3), letters[below(letters.size())]);
                break;
            case 3:
                bytes.erase(at, 1 + below(8));
                break;
            default:  // a piece of the file again, elsewhere
                bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        }
    }
    return bytes;
}

}  // namespace dem::fuzz
