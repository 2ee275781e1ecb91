#include <airlight/airlight.hpp>

// Linked with a file for each header: a function that is not inline would be defined twice.
int main() {
    return 0;
}
