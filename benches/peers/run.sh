#!/bin/sh
# Pinocchio and CasADi beside the generated code, same machine, same run: prints the table of the README.
#
#     benches/peers/run.sh [WORK]
#
# Needs python3 with venv, g++ and cargo; fetches Pinocchio, CasADi and clang (as `ziglang`) with pip into WORK (default
# target/peers). Pinocchio and CasADi have the arm's parameters as numbers in the program; ours takes them as an argument.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
work=${1:-$root/target/peers}
mkdir -p "$work"
venv=${PEERS_VENV:-$work/venv}
if [ ! -x "$venv/bin/python" ]; then
    python3 -m venv "$venv"
    "$venv/bin/pip" -q install pin casadi cmeel-eigen ziglang pyyaml
fi
site=$("$venv/bin/python" -c 'import sysconfig; print(sysconfig.get_paths()["purelib"])')
prefix=$site/cmeel.prefix
casadi=$site/casadi
clang="$venv/bin/python -m ziglang"
export ZIG_GLOBAL_CACHE_DIR="$work/zig" ZIG_LOCAL_CACHE_DIR="$work/zig"

cd "$root"
cargo build --release --quiet --bin denavit
rm -f "$work"/*.json
"$venv/bin/python" "$here/table.py" describe "$work"

# shellcheck disable=SC2086
compile() { # output, source, more
    out=$1; source=$2; shift 2
    [ "$out" -nt "$source" ] && return
    # What Pinocchio's CMake target asks for.
    set -- "$@" -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -DBOOST_FUSION_INVOKE_MAX_ARITY=12
    g++ -std=c++17 -DNDEBUG -I"$prefix/include" -I"$prefix/include/eigen3" -I"$casadi/include" "$source" -o "$out" "$@"
}
libraries="-L$prefix/lib -Wl,-rpath,$prefix/lib -lpinocchio_default"
# The headers' own templates (what a user who compiles for his machine gets), and the library's ready-made ones.
compile "$work/pinocchio-native" "$here/pinocchio.cpp" -O3 -march=native $libraries
compile "$work/pinocchio-library" "$here/pinocchio.cpp" -O3 -DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION $libraries
compile "$work/casadi_write" "$here/casadi_write.cpp" -O1 $libraries -L"$casadi" -Wl,-rpath,"$casadi" -lcasadi
compile "$work/casadi_time" "$here/casadi_time.cpp" -O2 $libraries -ldl
(cd "$work" && ./casadi_write model.txt kernels.c)
# zig compiles for the machine at hand whatever is said.
for flags in "-O3" "-O3 -march=native" "-O3 -march=native -ffast-math"; do
    name=$(echo "$flags" | tr -d ' ' | sed 's/-march=//; s/^-//')
    gcc $flags -fPIC -shared "$work/kernels.c" -o "$work/casadi-gcc-$name.so" -lm
    [ "$flags" = "-O3" ] || $clang cc -target native-native-gnu $flags -fPIC -shared "$work/kernels.c" -o "$work/casadi-clang-$name.so" -lm
done

# The measurements, one after the other.
for build in native library; do
    "$work/pinocchio-$build" "$work/model.txt" > "$work/pinocchio-g++-$build.json"
done
for library in "$work"/casadi-*.so; do
    "$work/casadi_time" "$work/model.txt" "$library" > "${library%.so}.json"
done
# A folder of its own: other flags would build everything in target anew.
CARGO_TARGET_DIR="$work/native" RUSTFLAGS="-C target-cpu=native" cargo bench --quiet --bench kernels -- kuka_lwr4 > "$work/kernels.txt"
# The full regressor once more without the drives of the robot file: 70 columns, which are all that the peers' have.
mkdir -p "$work/bare/src"
"$root/target/release/denavit" generate "$work/bare.yaml" --out "$work/bare/arm" > "$work/bare.log"
cp "$here/bare.rs" "$work/bare/src/main.rs"
name=$(sed -n 's/^name = "\(.*\)"/\1/p' "$work/bare/arm/Cargo.toml" | head -1)
sed -i '/^\[workspace\]/d' "$work/bare/arm/Cargo.toml"
cat > "$work/bare/Cargo.toml" << END
[package]
name = "time-bare"
version = "0.1.0"
edition = "2024"
[dependencies]
bare = { package = "$name", path = "arm" }
[profile.release]
lto = "thin"
codegen-units = 4
[workspace]
END
(cd "$work/bare" && RUSTFLAGS="-C target-cpu=native" cargo build --release --quiet)
: > "$work/bare.txt"
for round in 1 2 3 4 5 6 7; do
    "$work/pinocchio-native" "$work/model.txt" > "$work/again.txt"
    echo "$("$work/bare/target/release/time-bare") $(sed -n 's/.*"regressor": *\([0-9.]*\).*/\1/p' "$work/again.txt" | tail -1)" >> "$work/bare.txt"
done
grep -m1 'model name' /proc/cpuinfo | sed 's/.*: //'
"$venv/bin/python" "$here/table.py" table "$work"
