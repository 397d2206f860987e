# SPDX-License-Identifier: GPL-3.0-or-later
"""The saved state: what goes in comes out, and whatever happens to the file is noticed."""
import os
import random
import shutil
import tempfile
import unittest
import zipfile
from unittest import mock

import numpy as np
from freecad.featuremesh import state
from freecad.featuremesh.errors import StateError


def example():
    arrays = {"points": np.linspace(0, 1, 30).reshape(10, 3), "tets": np.arange(8, dtype=np.int32).reshape(2, 4),
              "tet_mids": np.zeros((0, 6), dtype=np.int32), "counters": np.array([1, 10, 11, 3])}
    raw = {"final_object": "Body", "shapes": bytes(range(256)) * 4,
           "records": [{"name": "Body", "label": "Körper", "links": [["Tip", "Pad", ""]], "numbers": {"Length": 0.1}}]}
    return state.State(raw, {"size": 0.1 + 0.2, "local": [["Face1", 2.0]]}, arrays, {"Fixed": ["Face1"]})


class StateFile(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.path = os.path.join(self.folder, "state.npz")

    def damaged(self, content):
        path = os.path.join(self.folder, "damaged.npz")
        with open(path, "wb") as stream:
            stream.write(content)
        with self.assertRaises(StateError):
            state.load(path)

    def test_what_goes_in_comes_out(self):
        before = example()
        checksum = state.save(self.path, before)
        after = state.load(self.path)
        self.assertEqual(after.raw, before.raw)
        self.assertEqual(after.options, before.options)
        self.assertEqual(after.references, before.references)
        self.assertEqual(set(after.arrays), set(before.arrays))
        for name, values in before.arrays.items():
            self.assertEqual(after.arrays[name].dtype, values.dtype)
            self.assertEqual(after.arrays[name].tobytes(), values.tobytes())
            self.assertEqual(after.arrays[name].shape, values.shape)
        self.assertEqual(state.checksum_of(self.path), checksum)

    def test_same_state_same_checksum_another_state_another(self):
        one, other = example(), example()
        other.arrays["points"] = other.arrays["points"] + 1e-12
        self.assertEqual(state.save(self.path, one), state.save(self.path, example()))
        self.assertNotEqual(state.save(self.path, one), state.save(self.path, other))

    def test_in_less_space_it_is_the_same(self):
        before = example()
        before.arrays["tet_numbers"] = np.arange(100_000)
        checksum = state.save(self.path, before)
        size = os.path.getsize(self.path)
        state.compress(self.path)
        self.assertLess(os.path.getsize(self.path), size // 2)
        self.assertEqual(state.checksum_of(self.path), checksum)
        after = state.load(self.path)
        self.assertEqual(after.raw, before.raw)
        for name, values in before.arrays.items():
            self.assertEqual(after.arrays[name].tobytes(), values.tobytes())
        self.assertEqual(os.listdir(self.folder), [os.path.basename(self.path)])

    def test_what_cannot_be_compressed_stays(self):
        checksum = state.save(self.path, example())
        with mock.patch.object(os, "replace", side_effect=PermissionError("in use")):
            state.compress(self.path)
        self.assertEqual((os.listdir(self.folder), state.checksum_of(self.path)), ([os.path.basename(self.path)], checksum))
        os.unlink(self.path)
        state.compress(self.path)
        with mock.patch.object(zipfile, "ZipFile", side_effect=zipfile.BadZipFile("cut short")):
            state.compress(self.path)
        self.assertEqual(os.listdir(self.folder), [])

    def test_missing(self):
        for path in ("", None, os.path.join(self.folder, "none.npz")):
            with self.assertRaises(StateError):
                state.load(path)
        self.assertEqual(state.checksum_of(os.path.join(self.folder, "none.npz")), "")

    def test_cut_short_and_foreign(self):
        state.save(self.path, example())
        with open(self.path, "rb") as stream:
            whole = stream.read()
        for share in (0, 0.01, 0.3, 0.7, 0.99):
            self.damaged(whole[:int(share * len(whole))])
        self.damaged(b"PK\x03\x04 not really a zip")
        np.savez(self.path, something=np.zeros(3))
        with self.assertRaisesRegex(StateError, "not a FeatureMesh state"):
            state.load(self.path)

    def test_flipped_bits_never_pass_as_another_state(self):
        seed = random.randrange(1 << 30)
        print("seed", seed)
        chance = random.Random(seed)
        before = example()
        state.save(self.path, before)
        with open(self.path, "rb") as stream:
            whole = stream.read()
        noticed = 0
        for _ in range(300):
            flipped = bytearray(whole)
            flipped[chance.randrange(len(whole))] ^= 1 << chance.randrange(8)
            with open(self.path, "wb") as stream:
                stream.write(flipped)
            try:
                after = state.load(self.path)
            except StateError:
                noticed += 1
                continue
            self.assertEqual(after.raw, before.raw)  # a bit that means nothing, such as a time stamp
            for name, values in before.arrays.items():
                self.assertEqual(after.arrays[name].tobytes(), values.tobytes())
        self.assertGreater(noticed, 150)

    def test_the_checksum_and_numbers_of_a_damaged_file_are_not_known(self):
        before = state.State(raw={"final_object": "", "records": [], "shapes": b""}, options={}, arrays={"counters": np.array([1, 4, 5, 9])})
        checksum = state.save(self.path, before)
        self.assertEqual(state.next_numbers_of(self.path), (5, 9))
        with open(self.path, "rb") as stream:
            whole = stream.read()
        for place in range(len(whole) - 600, len(whole)):   # where the archive says what is in it
            for bit in (1, 128):
                damaged = bytearray(whole)
                damaged[place] ^= bit
                with open(self.path, "wb") as stream:
                    stream.write(damaged)
                with self.subTest(place=place, bit=bit):
                    self.assertIn(state.checksum_of(self.path), ("", checksum))
                    self.assertIn(state.next_numbers_of(self.path), (None, (5, 9)))

    def test_pickles_are_refused(self):
        members = {"meta": np.array([{"a": 1}], dtype=object), "shapes": np.zeros(1, dtype=np.uint8)}
        np.savez(self.path, **members)
        with self.assertRaises(StateError):
            state.load(self.path)

    def test_newer_schema_and_migration(self):
        now = state.SCHEMA
        self.addCleanup(setattr, state, "SCHEMA", now)
        self.addCleanup(state.MIGRATIONS.pop, now, None)
        state.SCHEMA = now + 1
        state.save(self.path, example())
        state.SCHEMA = now
        with self.assertRaisesRegex(StateError, "newer FeatureMesh"):
            state.load(self.path)
        state.save(self.path, example())
        state.SCHEMA = now + 1
        state.MIGRATIONS[now] = lambda meta, members: (dict(meta, options={"size": 7.0}), members)
        self.assertEqual(state.load(self.path).options, {"size": 7.0})

    def of_schema_1(self, **arrays):
        """The arrays of a state that was saved by schema 1."""
        before = example()
        before.arrays.update(arrays)
        with mock.patch.object(state, "SCHEMA", 1):
            state.save(self.path, before)
        return state.load(self.path).arrays

    def test_schema_1_left_out_arrays_with_nothing_in_them(self):
        after = self.of_schema_1()
        for name, values in example().arrays.items():
            self.assertEqual(after[name].tobytes(), values.tobytes())
        self.assertEqual({name: values.tolist() for name, values in after.items() if name not in example().arrays},
                         {"made_for_nodes": [], "made_for_sizes": [], "adopted_sizes": [], "ignored_below": [0.0], "refined_narrow_faces": [False], "shared_nodes": []})

    def test_schema_1_told_refined_faces_by_an_empty_array(self):
        after = self.of_schema_1(refined_narrow_faces=np.zeros(0, np.int32), ignored_below=np.array([0.5]), made_for_nodes=np.array([3], np.int32),
                                 made_for_sizes=np.array([2.5]), adopted_sizes=np.ones((2, 4)))
        self.assertEqual([after[name].tolist() for name in ("refined_narrow_faces", "ignored_below", "made_for_nodes", "made_for_sizes", "adopted_sizes")],
                         [[True], [0.5], [3], [2.5], [[1.0] * 4] * 2])

    def test_failed_write_leaves_the_old_state(self):
        checksum = state.save(self.path, example())
        broken = example()
        broken.arrays["points"] = np.array([object()])
        with self.assertRaises(Exception):
            state.save(self.path, broken)
        self.assertEqual(state.checksum_of(self.path), checksum)
        self.assertEqual(os.listdir(self.folder), ["state.npz"])
