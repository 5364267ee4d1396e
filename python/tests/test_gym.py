"""The environment and the pairs."""

import numpy as np
import pytest

from pentimento import gym

SMALL = {"side": 48, "palette": ("French Ultramarine", "Titanium White")}


def test_an_episode_has_the_shape_of_gymnasiums():
    env = gym.PaintEnv(strokes=2, **SMALL)
    picture, info = env.reset(seed=3)
    assert env.observation_space.contains(picture) and info["strokes"] == 0
    action = env.action_space.sample()
    assert env.action_space.contains(action) and action.shape == (13,)
    after, reward, terminated, truncated, info = env.step(action)
    assert (after != picture).any() and reward == 0 and not terminated and not truncated and info["strokes"] == 1
    assert env.step(env.action_space.sample())[3], "two strokes are all"
    assert (env.render() == env.canvas.picture()).all()
    again, _ = env.reset()
    assert (again == picture).all(), "a fresh canvas"


def test_wider_spacing_paints_much_the_same_stroke():
    stroke = np.array([0.1, 0.5, 0.5, 0.5, 0.9, 0.5, 0.2, 0.2, 1, 0, 1, 1, 1], np.float32)
    wet = []
    for spacing in (gym.USUAL_SPACING, 0.125):
        env = gym.PaintEnv(spacing=spacing, **SMALL)
        env.reset()
        env.step(stroke)
        wet.append(env.canvas.state.depth_m.sum())
    assert wet[0] != wet[1] == pytest.approx(wet[0], rel=0.05), "as much paint, in fewer stamps"


def test_a_space_can_be_seeded():
    spaces = [gym.PaintEnv(**SMALL).action_space for _ in range(2)]
    for space in spaces:
        space.seed(5)
    assert (spaces[0].sample() == spaces[1].sample()).all()


def test_a_seed_gives_the_same_episode():
    def episode():
        env = gym.PaintEnv(**SMALL)
        env.reset(seed=7)
        for _ in range(3):
            env.step(env.action_space.sample())
        return env.canvas.state_sha256

    assert episode() == episode()


def test_the_reward_is_how_much_nearer_the_picture_came():
    blue = gym.PaintEnv(**SMALL)
    blue.reset(seed=1)
    stroke = np.array([0.1, 0.5, 0.5, 0.5, 0.9, 0.5, 0.2, 0.2, 1, 0, 1, 1, 1], np.float32)
    target = blue.step(stroke)[0]
    env = gym.PaintEnv(target=target, **SMALL)
    _, info = env.reset()
    picture, reward, *_ = env.step(stroke)
    assert (picture == target).all()
    assert reward == pytest.approx(info["distance"]) and reward > 0.01, "nothing is left"
    assert env.step(np.where(np.arange(13) == 8, 0, stroke) + np.eye(13)[9])[1] < 0, "white over it"


def test_the_brush_is_as_wide_as_the_action_says():
    env = gym.PaintEnv(**SMALL)
    env.reset()
    env.step(np.array([0.1, 0.5, 0.5, 0.5, 0.9, 0.5, 0.2, 0.2, 1, 0, 1, 1, 1], np.float32))
    rows = (env.canvas.state.depth_m[:, 24] > 1e-4).sum()
    assert 0.2 * 48 * 0.7 < rows < 0.2 * 48 * 1.4


def test_pairs_follow_each_other_and_repeat():
    first = list(gym.pairs(5, seed=2, strokes_each=3, **SMALL))
    second = list(gym.pairs(5, seed=2, strokes_each=3, **SMALL))
    assert len(first) == 5
    for a, b in zip(first, second):
        assert all((x == y).all() for x, y in zip(a, b))
    assert (first[0][2] == first[1][1]).all() and (first[0][1] == first[3][1]).all()


@pytest.mark.parametrize("action", [np.zeros(12), np.full(13, np.nan)])
def test_what_is_no_action_is_refused(action):
    env = gym.PaintEnv(**SMALL)
    env.reset()
    with pytest.raises(ValueError, match="an action is 13"):
        env.step(action)
    with pytest.raises(ValueError, match="the target is"):
        gym.PaintEnv(target=np.zeros((3, 3, 3)), **SMALL)
