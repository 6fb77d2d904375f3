#!/usr/bin/env python3
"""Trains the network of masks on rendered worlds: README.md beside this file.

    train.py WORLDS --output sherds.onnx [--steps 20000 | --seconds 600] [--start sherds.pt]

WORLDS contains folders that worlds.py and `ostraka rig simulate` made, named by their seeds. Seeds
from 900000 on are held out: none of them is trained on, and the figures printed at the end are
theirs. Worlds that appear while it runs are taken up.
"""
import argparse
import concurrent.futures
import inspect
import math
import pathlib
import time

import numpy as np
import torch
import torch.nn as nn
import torch.nn.functional as F
from PIL import Image

HELD_OUT = 900000
CROP = 384
LABELS = 41  # 0 and a batch's most sherds
WIDTHS = (16, 32, 64, 128, 192)


class Block(nn.Sequential):
    """Two convolutions."""

    def __init__(self, before, after):
        super().__init__(*[layer for width in (before, after) for layer in (
            nn.Conv2d(width, after, 3, padding=1, bias=False), nn.BatchNorm2d(after), nn.ReLU())])


class Network(nn.Module):
    """A U-Net (Ronneberger et al. 2015) that halves the picture before its first level.

    RGB, 0..1, n x 3 x h x w, sides multiples of 32 -> probability of sherd, n x 1 x h/2 x w/2.
    """

    def __init__(self):
        super().__init__()
        self.stem = nn.Conv2d(3, WIDTHS[0], 4, stride=2, padding=1)
        self.down = nn.ModuleList(
            Block(a, b) for a, b in zip((WIDTHS[0],) + WIDTHS[:-1], WIDTHS))
        self.up = nn.ModuleList(
            Block(a + b, b) for a, b in zip(WIDTHS[:0:-1], WIDTHS[-2::-1]))
        self.head = nn.Conv2d(WIDTHS[0], 1, 1)

    def logits(self, rgb):
        x = self.stem((rgb - 0.45) / 0.25)
        levels = []
        for i, block in enumerate(self.down):
            x = block(x if i == 0 else F.max_pool2d(x, 2))
            levels.append(x)
        for block, beside in zip(self.up, levels[-2::-1]):
            x = F.interpolate(x, scale_factor=2.0, mode="bilinear", align_corners=False)
            x = block(torch.cat((x, beside), 1))
        return self.head(x)

    def forward(self, rgb):
        return torch.sigmoid(self.logits(rgb))


def read(mask):
    """Photograph (h x w x 3) and labels (h x w), bytes, of truth/masks/SIDE_NAME.png."""
    side, name = mask.stem.split("_", 1)
    picture = np.array(Image.open(mask.parents[2] / side / (name + ".jpg")))
    return picture, np.array(Image.open(mask))


class Worlds:
    """Photographs (3 x h x w) and labels (1 x h x w), bytes, on the device; labels here, too."""

    def __init__(self, root, device):
        self.root, self.device = pathlib.Path(root), device
        self.seen, self.train, self.held_out = set(), [], []

    def refresh(self):
        for folder in sorted(self.root.iterdir()):
            masks = folder / "truth" / "masks"
            if not folder.name.isdigit() or folder.name in self.seen or not masks.is_dir():
                continue
            self.seen.add(folder.name)
            into = self.held_out if int(folder.name) >= HELD_OUT else self.train
            with concurrent.futures.ThreadPoolExecutor(4) as pool:
                for picture, label in pool.map(read, sorted(masks.iterdir())):
                    host = torch.from_numpy(label)[None]
                    into.append((
                        torch.from_numpy(picture).permute(2, 0, 1).contiguous().to(self.device),
                        host.to(self.device), host))


def noise_field(n, channels, cells, device):
    """Smooth noise of SD about 0.7, n x channels x CROP x CROP, with so many cells along a side."""
    return F.interpolate(torch.randn(n, channels, cells, cells, device=device), size=(CROP, CROP),
                         mode="bicubic", align_corners=False)


def cut_frame(labels, random):
    """A turned, scaled and mirrored square: 2 x 3 from -1..1 to pixels, and pixels per its pixel."""
    h, w = labels.shape[1:]
    centre = random.uniform(0, w), random.uniform(0, h)
    turn, zoom = random.uniform(-math.pi, math.pi), math.exp(random.uniform(-0.7, 0.5))
    half, flip = CROP / 2 * zoom, random.choice((-1, 1))
    if random.random() < 0.5:
        found = labels[0, ::16, ::16].nonzero()
        if len(found):
            y, x = found[random.integers(len(found))]
            centre = 16 * x + random.normal() * half / 2, 16 * y + random.normal() * half / 2
    c, s = half * math.cos(turn), half * math.sin(turn)
    return np.array([[flip * c, -s, centre[0]], [flip * s, c, centre[1]]]), zoom


def crops(pairs, n, random, device):
    """n cuts, half of them about a sherd, six of each photograph: pictures 0..1 and labels."""
    pictures, labels = [], []
    for _ in range(n // 6):
        picture, label, host = pairs[random.integers(len(pairs))]
        h, w = label.shape[1:]
        frames, zooms = zip(*[cut_frame(host, random) for _ in range(6)])
        scale = np.array([[2 / w], [2 / h]])
        theta = torch.tensor(np.array(frames) * scale - [[0, 0, 1], [0, 0, 1]], dtype=torch.float32)
        grid = F.affine_grid(theta.to(device), (6, 1, CROP, CROP), align_corners=False)
        light = picture.float()[None] / 255
        if max(zooms) > 1.4:  # else fine patterns turn coarse
            light = F.avg_pool2d(light, 2)
        pictures.append(F.grid_sample(light.expand(6, -1, -1, -1), grid, padding_mode="reflection",
                                      align_corners=False))
        labels.append(F.grid_sample(label.float()[None].expand(6, -1, -1, -1), grid, mode="nearest",
                                    padding_mode="reflection", align_corners=False))
    return torch.cat(pictures), torch.cat(labels).long()


def maybe(n, share, device):
    return (torch.rand(n, 1, 1, 1, device=device) < share).float()


def of_things(values, labels):
    """Each thing's own value: n x c x LABELS by n x 1 x h x w -> n x c x h x w; 0 beside things."""
    n, c = values.shape[:2]
    values = values.clone()
    values[:, :, 0] = 0
    return values.gather(2, labels.view(n, 1, -1).expand(-1, c, -1)).view(n, c, *labels.shape[2:])


def patches(n, channels, device):
    """Prints, panels, stains: areas of one colour each with sharp edges, SD about 1."""
    cells = noise_field(n, 4, int(2 ** np.random.uniform(1.5, 6)), device)
    which = cells.argmax(1, keepdim=True)
    colours = torch.randn(n, channels, 4, device=device)
    return colours.gather(2, which.view(n, 1, -1).expand(-1, channels, -1)).view(
        n, channels, CROP, CROP)


def altered(pictures, labels):
    """Other clays, things, grounds, shadows, lights and cameras, as factors of the linear light."""
    n, device = len(pictures), pictures.device
    things = (labels > 0).float()
    log = (pictures.clamp(1e-3, 1) ** 2.2).log()

    def normal(channels=1):
        return torch.randn(n, channels, 1, 1, device=device)

    def own(channels=1):
        return of_things(torch.randn(n, channels, LABELS, device=device), labels)

    # Some things turn smooth, of any colour: glaze, plastic, fruit, card. Only their shading stays.
    smooth = of_things((torch.rand(n, 1, LABELS, device=device) < 0.25).float(), labels)
    weight = F.avg_pool2d(things, 13, 1, 6).clamp(min=1e-3)
    shading = F.avg_pool2d(log.mean(1, keepdim=True) * things, 13, 1, 6) / weight
    colour = torch.log(0.02 + 0.9 * torch.rand(n, 3, LABELS, device=device))
    colour = of_things(colour - 0.5 * colour.mean(1, keepdim=True), labels)
    log = smooth * (shading + colour) + (1 - smooth) * log
    # Some get the colour of what they lie on: only grain, shading and edge tell them from it.
    where = labels.view(n, 1, -1).expand(-1, 3, -1)
    sums = torch.zeros(n, 3, LABELS, device=device).scatter_add_(2, where, log.view(n, 3, -1))
    counts = torch.zeros(n, 3, LABELS, device=device).scatter_add_(
        2, where, torch.ones_like(log.view(n, 3, -1)))
    means = sums / counts.clamp(min=1)
    shift = means[:, :, :1] - means + 0.15 * torch.randn(n, 1, LABELS, device=device)
    hidden = (torch.rand(n, 1, LABELS, device=device) < 0.15).float()
    log = log + of_things(shift * hidden, labels)
    # All get other colours, some other patterns; so do grounds, less often.
    cells = int(2 ** np.random.uniform(1, 6.5))
    thing = maybe(n, 0.6, device) * (0.5 * own() + 0.3 * own(3))
    thing = thing + maybe(n, 0.3, device) * noise_field(n, 3, cells, device) * 0.4 * normal().abs()
    thing = thing + maybe(n, 0.2, device) * patches(n, 3, device) * 0.5 * normal().abs()
    ground = maybe(n, 0.4, device) * (0.3 * normal() + 0.15 * normal(3))
    uneven = noise_field(n, 1, cells, device) + 0.3 * noise_field(n, 3, cells, device)
    ground = ground + maybe(n, 0.25, device) * uneven * 0.2 * normal().abs()
    ground = ground + maybe(n, 0.15, device) * patches(n, 3, device) * 0.4 * normal().abs()
    log = log + things * thing + (1 - things) * ground
    # Shadows with any edge, over all that is there.
    edge = noise_field(n, 1, int(2 ** np.random.uniform(1, 4)), device) + normal()
    shade = torch.sigmoid(edge * 10 ** (1.5 * torch.rand(n, 1, 1, 1, device=device)))
    log = log - maybe(n, 0.5, device) * shade * (
        2 * torch.rand(n, 1, 1, 1, device=device) + 0.08 * normal(3))
    # Exposure, white balance, tone, sharpness, noise.
    log = log + 0.3 * normal() + 0.1 * normal(3)
    out = log.exp().clamp(0, 1) ** (torch.exp(0.2 * normal()) / 2.2)
    grey = maybe(n, 0.05, device)
    out = grey * out.mean(1, keepdim=True) + (1 - grey) * out
    blurred = F.avg_pool2d(F.pad(out, (1, 1, 1, 1), mode="reflect"), 3, 1)
    soft = maybe(n, 0.4, device) * torch.rand(n, 1, 1, 1, device=device)
    out = soft * blurred + (1 - soft) * out
    return (out + torch.randn_like(out) * 0.02 * normal().abs()).clamp(0, 1)


def padded(picture):
    h, w = picture.shape[-2:]
    return F.pad(picture[None].float() / 255, (0, -w % 32, 0, -h % 32), mode="replicate")


@torch.no_grad()
def figures(network, pairs):
    """IoU by photograph and by world's mean, and how often p is right, by deciles of p."""
    network.eval()
    scores, sums = [], np.zeros((10, 3))
    for picture, labels, _ in pairs:
        h, w = labels.shape[1:]
        p = F.interpolate(network(padded(picture)), scale_factor=2.0, mode="bilinear",
                          align_corners=False)[0, :, :h, :w]
        truth, says = labels > 0, p > 0.5
        scores.append(((truth & says).sum() / (truth | says).sum().clamp(min=1)).item())
        place = (p * 10).long().clamp(0, 9)
        for i in range(10):
            here = place == i
            sums[i] += here.sum().item(), p[here].sum().item(), truth[here].sum().item()
    scores = np.array(scores)
    print("held out: %d photographs, IoU mean %.4f, median %.4f, tenth %.4f, least %.4f" % (
        len(scores), scores.mean(), np.median(scores), np.quantile(scores, 0.1), scores.min()))
    for count, p, truth in sums:
        print("  said %.3f, was %.3f, share %.5f" % (
            p / max(count, 1), truth / max(count, 1), count / sums[:, 0].sum()))


def train(worlds, options, device):
    torch.manual_seed(options.seed)
    np.random.seed(options.seed)
    random = np.random.default_rng(options.seed)
    network = Network().to(device)
    if options.start:
        network.load_state_dict(torch.load(options.start, map_location=device))
    average = torch.optim.swa_utils.AveragedModel(
        network, avg_fn=lambda mean, now, count: mean + (now - mean) / min(500, 1 + count))
    optimizer = torch.optim.AdamW(network.parameters(), lr=1e-3, weight_decay=0.02)
    begin = refreshed = time.time()
    step, loss_mean = 0, 0.0
    while True:
        now = time.time()
        done = (now - begin) / options.seconds if options.seconds else step / options.steps
        if done >= 1:
            break
        if now - refreshed > 20:
            refreshed = now
            worlds.refresh()
        for group in optimizer.param_groups:
            group["lr"] = options.rate * min(1, (step + 1) / 300) * 0.5 * (
                1 + math.cos(math.pi * done))
        with torch.no_grad():
            pictures, labels = crops(worlds.train, options.batch, random, device)
            goal = F.avg_pool2d((labels > 0).float(), 2)
            pictures = altered(pictures, labels)
        network.train()
        with torch.autocast(device.type, dtype=torch.bfloat16, enabled=device.type == "cuda"):
            logits = network.logits(pictures.to(memory_format=torch.channels_last))
        logits = logits.float()
        p = torch.sigmoid(logits)
        overlap = (p * goal).sum((1, 2, 3)) + 20
        union = (p + goal - p * goal).sum((1, 2, 3)) + 20
        loss = F.binary_cross_entropy_with_logits(logits, goal) + 0.3 * (1 - overlap / union).mean()
        optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 2)
        optimizer.step()
        average.update_parameters(network)
        if step % 20 == 0:
            loss_mean += (loss.item() - loss_mean) / min(20, step // 20 + 1)
        if step % 500 == 0:
            print("step %d, %.0f s, %d photographs, loss %.4f" % (
                step, now - begin, len(worlds.train), loss_mean), flush=True)
        step += 1
    print("%d steps, %d photographs" % (step, len(worlds.train)))
    mean = average.module
    mean.train()
    with torch.no_grad():  # normalisation as the mean weights see it
        for layer in mean.modules():
            if isinstance(layer, nn.BatchNorm2d):
                layer.reset_running_stats()
                layer.momentum = None
        for _ in range(100):
            mean(altered(*crops(worlds.train, options.batch, random, device)))
    return mean.eval()


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("worlds")
    arguments.add_argument("--output", required=True)
    arguments.add_argument("--start", help="weights to go on from, as --weights wrote them")
    arguments.add_argument("--weights", help="also write PyTorch's weights here")
    arguments.add_argument("--steps", type=int, default=20000)
    arguments.add_argument("--seconds", type=float)
    arguments.add_argument("--batch", type=int, default=48, help="a multiple of 6")
    arguments.add_argument("--rate", type=float, default=2e-3)
    arguments.add_argument("--seed", type=int, default=1)
    options = arguments.parse_args()
    device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
    worlds = Worlds(options.worlds, device)
    worlds.refresh()
    if not worlds.train or options.batch < 6:
        arguments.error("needs worlds to train on, and six cuts at least in a batch")
    network = train(worlds, options, device)
    worlds.refresh()
    if worlds.held_out:
        figures(network, worlds.held_out)
    network = network.float().cpu()
    if options.weights:
        torch.save(network.state_dict(), options.weights)
    newer = "dynamo" in inspect.signature(torch.onnx.export).parameters
    torch.onnx.export(network, torch.rand(1, 3, 768, 1024), options.output, opset_version=11,
                      input_names=["photograph"], output_names=["sherd"],
                      dynamic_axes={"photograph": {2: "h", 3: "w"}, "sherd": {2: "h", 3: "w"}},
                      **({"dynamo": False} if newer else {}))


if __name__ == "__main__":
    main()
