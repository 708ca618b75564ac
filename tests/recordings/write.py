#!/usr/bin/env python3
"""Writes the recordings of this folder with writers that share no code with the reader.

    pip install mcap rosbags numpy scipy pyarrow
    python3 tests/recordings/write.py

Every file holds the same motion of two joints, `elbow` and `shoulder`, at 100 Hz for 2 s:
q = (0.8 sin 2t, 0.5 cos 3t), tau = 10 q + (0, 1). Joints stand in the recordings in the order
elbow, shoulder; positions and torques of joint `shoulder` are the first of the two.
"""
import io, os, sqlite3, struct
from pathlib import Path
from tempfile import TemporaryDirectory
import numpy as np
import scipy.io
import pyarrow as pa, pyarrow.parquet as pq
from mcap.writer import Writer, CompressionType
from rosbags.rosbag2 import StoragePlugin, Writer as Bag2
from rosbags.typesys import Stores, get_typestore

here = Path(__file__).parent
n, rate = 200, 100.0
t = np.arange(n) / rate
q = np.stack([0.8 * np.sin(2 * t), 0.5 * np.cos(3 * t)])          # shoulder, elbow
dq = np.stack([1.6 * np.cos(2 * t), -1.5 * np.sin(3 * t)])
tau = 10 * q + np.array([[0.0], [1.0]])
EPOCH = 1_700_000_000_000_000_000
store = get_typestore(Stores.ROS2_HUMBLE)
T = store.types


def stamp(seconds):
    ns = EPOCH + int(round(seconds * 1e9))
    return T["builtin_interfaces/msg/Time"](sec=ns // 10**9, nanosec=ns % 10**9), ns


def header(seconds):
    return T["std_msgs/msg/Header"](stamp=stamp(seconds)[0], frame_id="base")


def joint_state(k, effort=True, velocity=True):
    pick = lambda a: np.array([a[1, k], a[0, k]])                   # elbow first
    none = np.array([], dtype=np.float64)
    return T["sensor_msgs/msg/JointState"](
        header=header(t[k]), name=["elbow", "shoulder"], position=pick(q),
        velocity=pick(dq) if velocity else none, effort=pick(tau) if effort else none)


def cdr(kind, message, big=False):
    return bytes(store.serialize_cdr(message, kind, little_endian=not big))


def schema_text(kind):
    return store.generate_msgdef(kind, ros_version=2)[0]


class Bag:
    def __init__(self, name, compression=CompressionType.NONE, chunk=8192):
        self.out = open(here / name, "wb")
        self.w = Writer(self.out, chunk_size=chunk, compression=compression)
        self.w.start("ros2", library="write.py")
        self.channels = {}

    def add(self, topic, kind, payload, seconds, text=None):
        if topic not in self.channels:
            body = (schema_text(kind) if text is None else text).encode()
            schema = self.w.register_schema(kind, "ros2msg", body)
            self.channels[topic] = self.w.register_channel(topic, "cdr", schema)
        ns = EPOCH + int(round(seconds * 1e9))
        self.w.add_message(self.channels[topic], ns, payload, ns)

    def close(self):
        self.w.finish()
        self.out.close()


JS = "sensor_msgs/msg/JointState"
for name, compression, big in [("joint_state.mcap", CompressionType.ZSTD, False), ("joint_state_lz4.mcap", CompressionType.LZ4, False),
                               ("joint_state_big_endian.mcap", CompressionType.NONE, True)]:
    bag = Bag(name, compression)
    for k in range(n):
        bag.add("/joint_states", JS, cdr(JS, joint_state(k), big), t[k] + 0.002)
        if k % 20 == 0:
            bag.add("/rosout", "std_msgs/msg/String", cdr("std_msgs/msg/String", T["std_msgs/msg/String"](data=f"step {k}")), t[k])
    bag.close()

# Empty velocities, and torques from a stream of its own, at another rate with its own stamps.
bag = Bag("two_clocks.mcap", CompressionType.ZSTD)
W = "std_msgs/msg/Float64MultiArray"
events = [(t[k], 0, k) for k in range(n)] + [(s, 1, s) for s in np.arange(-0.003, 2.01, 0.004)]
for at, kind, what in sorted(events):
    if kind == 0:
        bag.add("/joint_states", JS, cdr(JS, joint_state(what, effort=False, velocity=False)), at)
    else:
        qq = np.array([0.8 * np.sin(2 * what), 0.5 * np.cos(3 * what)])
        layout = T["std_msgs/msg/MultiArrayLayout"](dim=[], data_offset=0)
        bag.add("/torques", W, cdr(W, T[W](layout=layout, data=10 * qq + np.array([0.0, 1.0]))), at)
bag.close()

# Interfaces by joint (ros2_control), written by hand in XCDR2 (doubles aligned to four bytes).
bag = Bag("dynamic_joint_state_xcdr2.mcap")
DJ = "control_msgs/msg/DynamicJointState"
text = """std_msgs/Header header
string[] joint_names
control_msgs/InterfaceValue[] interface_values
================================================================================
MSG: control_msgs/InterfaceValue
string[] interface_names
float64[] values
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec"""


class X2:
    def __init__(self): self.b = bytearray()
    def pad(self, s):
        while len(self.b) % min(s, 4): self.b.append(0)
    def u32(self, v): self.pad(4); self.b += struct.pack("<I", v)
    def f64(self, v): self.pad(8); self.b += struct.pack("<d", v)
    def text(self, s): self.u32(len(s) + 1); self.b += s.encode() + b"\0"


for k in range(n):
    x = X2()
    s, _ = stamp(t[k])
    x.u32(s.sec); x.u32(s.nanosec); x.text("base")
    x.u32(2); x.text("elbow"); x.text("shoulder")
    x.u32(2)
    for j in (1, 0):
        x.u32(3); [x.text(i) for i in ("position", "velocity", "effort")]
        x.u32(3); [x.f64(v) for v in (q[j, k], dq[j, k], tau[j, k])]
    bag.add("/dynamic_joint_states", DJ, b"\0\x07\0\0" + bytes(x.b), t[k], text)
bag.close()

# A recorder that was killed: the file ends in the middle.
whole = (here / "joint_state_big_endian.mcap").read_bytes()
(here / "cut.mcap").write_bytes(whole[: len(whole) * 6 // 10])

np.savez(here / "arrays.npz", t=t, q=q.T, tau=np.asfortranarray(tau.T), note=np.array("text"))
np.savez_compressed(here / "arrays_compressed.npz", t=t.astype(">f8"), q=q, tau=tau)
np.savez(here / "pickle.npz", t=t, q=np.array([{"a": 1}], dtype=object))
scipy.io.savemat(here / "arrays.mat", {"t": t, "q": q, "tau": tau})
scipy.io.savemat(here / "structure.mat", {"log": {"t": t, "q": q.T, "tau": tau.T}}, do_compression=True)

# An episode as LeRobot writes it: lists of fixed length, single precision.
lists = lambda a: pa.FixedSizeListArray.from_arrays(pa.array(a.T.astype(np.float32).ravel()), 2)
pq.write_table(pa.table({"timestamp": pa.array(t.astype(np.float32)), "observation.state": lists(q), "observation.effort": lists(tau),
                         "episode_index": pa.array(np.zeros(n, dtype=np.int64)), "task": pa.array(["wave"] * n)}), here / "lerobot.parquet")
variable = lambda a: pa.array([row.tolist() for row in a.T], type=pa.list_(pa.float64()))
pq.write_table(pa.table({"t": t, "q": variable(q), "tau": variable(tau)}), here / "lists.parquet")

# Stamps with a type of their own, and columns packed otherwise than with snappy.
stamps = pa.array([np.datetime64(EPOCH + int(round(s * 1e9)), "ns") for s in t])
plain = {"t": stamps, "q1": q[0], "q2": q[1], "tau1": tau[0], "tau2": tau[1]}
for packing in ("gzip", "lz4", "zstd"):
    pq.write_table(pa.table(plain), here / f"stamps_{packing}.parquet", compression=packing)

# Degrees, milliseconds, N mm, semicolons, decimal commas: a German spreadsheet.
with open(here / "german.csv", "w") as f:
    f.write("Zeit;Achse 1 Position [deg];Achse 2 Position [deg];Achse 1 Moment;Achse 2 Moment\n")
    for k in range(n):
        cells = [1000 * t[k], *np.degrees(q[:, k]), *(1000 * tau[:, k])]
        f.write(";".join(f"{c:.9g}".replace(".", ",") for c in cells) + "\n")

# rosbag2's SQLite.
with TemporaryDirectory() as place:
    with Bag2(Path(place) / "bag", version=8, storage_plugin=StoragePlugin.SQLITE3) as bag:
        joint_states = bag.add_connection("/joint_states", JS, typestore=store)
        rosout = bag.add_connection("/rosout", "std_msgs/msg/String", typestore=store)
        for k in range(n):
            ns = EPOCH + int(round((t[k] + 0.002) * 1e9))
            bag.write(joint_states, ns, cdr(JS, joint_state(k)))
            if k % 20 == 0:
                text = T["std_msgs/msg/String"](data=f"step {k}")
                bag.write(rosout, ns, cdr("std_msgs/msg/String", text))
    (here / "rosbag2").mkdir(exist_ok=True)
    for name in ("bag.db3", "metadata.yaml"):
        (here / "rosbag2" / name).write_bytes((Path(place) / "bag" / name).read_bytes())
