"""A client that shares no code with gonio: Debian's grpcio, messages from protoc, generic calls.

Usage: python_client_test.py GONIOD   (PYTHONPATH holds the generated gonio/v1/*_pb2.py)
"""

import hashlib
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
import unittest

import grpc

from gonio.v1 import error_pb2, evaluate_pb2, fit_pb2, models_pb2, put_pb2, sample_pb2

GONIOD = sys.argv.pop(1)
SERVICE = "/gonio.v1.GonioService/"


def directions(count, seed):
    """Unit vectors over the whole sphere, interleaved xyz, as float32."""
    numbers = []
    generator = random.Random(seed)
    for _ in range(count):
        v = [generator.gauss(0, 1) for _ in range(3)]
        length = math.sqrt(sum(x * x for x in v))
        numbers += [struct.unpack("f", struct.pack("f", x / length))[0] for x in v]
    return numbers


def lambertian(colour):
    request = evaluate_pb2.EvaluateRequest()
    request.material.model = "lambertian"
    request.material.parameters["rd"] = colour
    return request


class PythonClient(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        address = "unix:" + os.path.join(cls.folder.name, "socket")
        cls.server = subprocess.Popen([GONIOD, "--listen", address, "--lame-duck", "0"])
        cls.channel = grpc.insecure_channel(address)
        grpc.channel_ready_future(cls.channel).result(timeout=60)
        evaluate = evaluate_pb2
        cls.evaluate = staticmethod(cls.channel.unary_unary(
            SERVICE + "Evaluate", evaluate.EvaluateRequest.SerializeToString,
            evaluate.EvaluateResponse.FromString))
        cls.evaluate_stream = staticmethod(cls.channel.stream_stream(
            SERVICE + "EvaluateStream", evaluate.EvaluateStreamRequest.SerializeToString,
            evaluate.EvaluateStreamResponse.FromString))
        cls.fit = staticmethod(cls.channel.unary_stream(
            SERVICE + "Fit", fit_pb2.FitRequest.SerializeToString, fit_pb2.FitResponse.FromString))
        cls.put_material = staticmethod(cls.channel.stream_unary(
            SERVICE + "PutMaterial", put_pb2.PutMaterialRequest.SerializeToString,
            put_pb2.PutMaterialResponse.FromString))
        cls.sample = staticmethod(cls.channel.unary_unary(
            SERVICE + "Sample", sample_pb2.SampleRequest.SerializeToString,
            sample_pb2.SampleResponse.FromString))
        cls.integrate = staticmethod(cls.channel.unary_unary(
            SERVICE + "Integrate", sample_pb2.IntegrateRequest.SerializeToString,
            sample_pb2.IntegrateResponse.FromString))
        cls.list_models = staticmethod(cls.channel.unary_unary(
            SERVICE + "ListModels", models_pb2.ListModelsRequest.SerializeToString,
            models_pb2.ListModelsResponse.FromString))

    @classmethod
    def tearDownClass(cls):
        cls.channel.close()
        cls.server.terminate()
        status = cls.server.wait(timeout=60)
        cls.folder.cleanup()
        assert status == 0, f"goniod ended with {status}"

    def check(self, response, colour, wi, wo):
        """Every value and flag against the formula."""
        pairs = len(wi) // 3
        self.assertEqual(response.channels, len(colour))
        self.assertEqual(len(response.values), pairs * len(colour))
        self.assertIn(len(response.flags), (0, pairs))
        for i in range(pairs):
            below = 8 * (wi[3 * i + 2] <= 0) | 16 * (wo[3 * i + 2] <= 0)
            self.assertEqual(response.flags[i] if response.flags else 0, below)
            for c, rd in enumerate(colour):
                expected = 0 if below else rd / math.pi
                value = response.values[i * len(colour) + c]
                self.assertAlmostEqual(value, expected, delta=1e-6 * expected)

    def test_lists_models(self):
        response = self.list_models(models_pb2.ListModelsRequest(), timeout=60)
        self.assertIn("ggx", [model.name for model in response.models])
        self.assertIn(evaluate_pb2.INSTRUCTION_SET_BASELINE, response.instruction_sets)

    def test_evaluates_a_batch(self):
        colour = [0.5, 0.25, 1.0]
        request = lambertian(colour)
        request.pairs.wi.extend(directions(1000, 1))
        request.pairs.wo.extend(directions(1000, 2))
        response = self.evaluate(request, timeout=60)
        self.check(response, colour, request.pairs.wi, request.pairs.wo)
        self.assertTrue(any(response.flags) and not all(response.flags))
        self.assertEqual(response.report.precision, evaluate_pb2.PRECISION_FAST)
        self.assertGreater(response.report.error_bound.relative, 0)

    def test_samples(self):
        """A Lambertian surface is drawn by the cosine: pdf cos(theta) / pi, weight rd."""
        colour = [0.5, 0.25]
        request = sample_pb2.SampleRequest(per_wi=500, seed=3, wi=[0, 0, 1, 0.6, 0, 0.8])
        request.material.CopyFrom(lambertian(colour).material)
        response = self.sample(request, timeout=60)
        self.assertEqual(len(response.pdf), 1000)
        self.assertEqual(response.lost, 0)
        for i in range(1000):
            x, y, z = response.wo[3 * i:3 * i + 3]
            self.assertAlmostEqual(x * x + y * y + z * z, 1, delta=1e-6)
            self.assertAlmostEqual(response.pdf[i], z / math.pi, delta=1e-6)
            for c, rd in enumerate(colour):
                self.assertAlmostEqual(response.weights[2 * i + c], rd, delta=1e-5)
        # Any run of them again, and their densities from Evaluate.
        request.first, request.count = 700, 100
        again = self.sample(request, timeout=60)
        self.assertEqual(list(again.wo), list(response.wo[2100:2400]))
        pairs = lambertian(colour)
        pairs.pdf = True
        pairs.pairs.wi.extend([0.6, 0, 0.8] * 100)
        pairs.pairs.wo.extend(again.wo)
        self.assertEqual(list(self.evaluate(pairs, timeout=60).pdf), list(again.pdf))

    def test_integrates(self):
        request = sample_pb2.IntegrateRequest(per_wi=1000, wi=[0, 0, 1])
        request.material.CopyFrom(lambertian([0.5, 0.25]).material)
        response = self.integrate(request, timeout=60)
        self.assertAlmostEqual(response.albedo[0], 0.5, delta=1e-5)
        self.assertAlmostEqual(response.albedo[1], 0.25, delta=1e-5)
        self.assertLess(response.standard_error[0], 1e-5)

    def test_reference_precision(self):
        request = lambertian([0.5])
        request.precision = evaluate_pb2.PRECISION_REFERENCE
        request.pairs_f64.wi.extend([0, 0, 1])
        request.pairs_f64.wo.extend([0.6, 0, 0.8])
        response = self.evaluate(request, timeout=60)
        self.assertEqual(len(response.values), 0)
        self.assertAlmostEqual(response.values_f64[0], 0.5 / math.pi, delta=1e-15)

    def test_bad_request_says_what_is_wrong(self):
        request = lambertian([7])
        request.pairs.wi.extend([0, 0, 1])
        request.pairs.wo.extend([0, 0, 1])
        with self.assertRaises(grpc.RpcError) as raised:
            self.evaluate(request, timeout=60)
        self.assertEqual(raised.exception.code(), grpc.StatusCode.INVALID_ARGUMENT)
        metadata = dict(raised.exception.trailing_metadata())
        detail = error_pb2.ErrorDetail.FromString(metadata["grpc-status-details-bin"])
        self.assertEqual(detail.code, grpc.StatusCode.INVALID_ARGUMENT.value[0])
        self.assertTrue(detail.field.startswith("material.parameters.rd"), detail.field)
        self.assertEqual(detail.value, "7")
        self.assertIn("1", detail.allowed)
        self.assertEqual(detail.message, raised.exception.details())

    def test_fits_what_it_measured(self):
        colour = [0.5, 0.25]
        truth = lambertian(colour)
        truth.pairs.wi.extend(directions(2000, 3))
        truth.pairs.wo.extend(directions(2000, 4))
        measured = self.evaluate(truth, timeout=60)
        request = fit_pb2.FitRequest()
        request.pairs.wi.extend(truth.pairs.wi)
        request.pairs.wo.extend(truth.pairs.wo)
        request.pairs.values.extend(measured.values)
        request.pairs.channels = measured.channels
        request.form.model = "lambertian"
        answers = list(self.fit(request, timeout=60))
        self.assertTrue(all(a.HasField("progress") for a in answers[:-1]))
        certificate = answers[-1].result.certificate
        self.assertNotEqual(certificate.verdict, fit_pb2.FIT_VERDICT_FAILED, certificate.reason)
        below = sum(1 for flag in measured.flags if flag)
        self.assertEqual(certificate.left_out.below_horizon, below)
        self.assertEqual(certificate.pairs, 2000 - below)
        for found, rd in zip(answers[-1].result.material.parameters["rd"], colour):
            self.assertAlmostEqual(found, rd, delta=1e-5)

    def test_puts_a_material_and_fits_it_by_name(self):
        """A MERL file whose values are 0.1, 0.05 and 0.025 everywhere, but for one cell."""
        cells = 90 * 90 * 180
        planes = [struct.pack("<d", f * 1500 / scale) * cells
                  for f, scale in ((0.1, 1), (0.05, 1.15), (0.025, 1.66))]
        planes[0] = struct.pack("<d", -1) + planes[0][8:]
        content = struct.pack("<3i", 90, 90, 180) + b"".join(planes)

        def parts(digest):
            yield put_pb2.PutMaterialRequest(file=put_pb2.MaterialFile(
                name="grey", size=len(content), sha256=digest))
            for at in range(0, len(content), 1 << 18):
                yield put_pb2.PutMaterialRequest(chunk=content[at:at + (1 << 18)])

        with self.assertRaises(grpc.RpcError) as raised:
            self.put_material(parts(hashlib.sha256(b"other").digest()), timeout=60)
        self.assertEqual(raised.exception.code(), grpc.StatusCode.DATA_LOSS)
        metadata = dict(raised.exception.trailing_metadata())
        detail = error_pb2.ErrorDetail.FromString(metadata["grpc-status-details-bin"])
        self.assertEqual(detail.field, "file.sha256")
        self.assertIn(hashlib.sha256(content).hexdigest(), detail.allowed)

        stored = self.put_material(parts(hashlib.sha256(content).digest()), timeout=60)
        self.assertEqual(stored.place, put_pb2.MATERIAL_PLACE_MEMORY)
        self.assertEqual(stored.invalid_cells, 1)
        request = fit_pb2.FitRequest()
        request.measured.name = "grey"
        request.form.model = "lambertian"
        first, again = (list(self.fit(request, timeout=60))[-1].result for _ in range(2))
        for found, f in zip(first.material.parameters["rd"], (0.1, 0.05, 0.025)):
            self.assertAlmostEqual(found, f * math.pi, delta=1e-4)
        self.assertEqual(first.material, again.material)
        self.assertEqual(first.certificate.parameters, again.certificate.parameters)

    def test_cancels_a_fit(self):
        request = fit_pb2.FitRequest()
        request.pairs.wi.extend([0.6, 0, 0.8] * 50000)
        request.pairs.wo.extend([-0.6, 0, 0.8] * 50000)
        request.pairs.values.extend([1] * 50000)
        request.pairs.channels = 1
        request.form.specular.add().model = "ggx"
        request.options.starts = 100
        request.options.polish = True
        call = self.fit(request, timeout=60)
        next(call)
        call.cancel()
        with self.assertRaises(grpc.RpcError) as raised:
            list(call)
        self.assertEqual(raised.exception.code(), grpc.StatusCode.CANCELLED)

    def test_streams_chunks(self):
        colour = [0.5, 0.25]
        chunks = {}
        for sequence in range(20):
            chunk = evaluate_pb2.EvaluateStreamRequest(sequence=sequence, slot=3)
            if sequence == 0:
                chunk.evaluate.material.CopyFrom(lambertian(colour).material)
            chunk.evaluate.pairs.wi.extend(directions(300, sequence))
            chunk.evaluate.pairs.wo.extend(directions(300, sequence + 1000))
            chunks[sequence] = chunk
        chunks[7].evaluate.pairs.wo.pop()  # one bad chunk leaves the others alone
        answers = {a.sequence: a for a in self.evaluate_stream(iter(chunks.values()), timeout=60)}
        self.assertEqual(sorted(answers), sorted(chunks))
        for sequence, answer in answers.items():
            if sequence == 7:
                self.assertEqual(answer.error.code, grpc.StatusCode.INVALID_ARGUMENT.value[0])
                continue
            pairs = chunks[sequence].evaluate.pairs
            self.check(answer.evaluate, colour, pairs.wi, pairs.wo)


if __name__ == "__main__":
    unittest.main(verbosity=2)
