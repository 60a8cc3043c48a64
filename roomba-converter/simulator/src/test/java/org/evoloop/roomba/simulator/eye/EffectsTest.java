package org.evoloop.roomba.simulator.eye;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.junit.jupiter.api.Test;

class EffectsTest {
    /** So near and so large that the tag's black left border is at least as wide as any blur. */
    private static final Room NEAR_TAG =
            Shot.PLAIN.withMarker(new Marker(new Pose(1_000, 0, Math.PI), 0, 600, 400, false, false));

    private static final int MIDDLE_ROW = 150;

    private static Shot shot(Effects effects) {
        return Shot.of(Shot.with(effects), NEAR_TAG);
    }

    /** The standard deviation of an edge's transition from white to black, within 40 pixels. */
    private static double edgeWidthPx(Shot shot, int edge) {
        double sum = 0;
        double first = 0;
        double second = 0;
        for (int at = edge - 40; at < edge + 40; at++) {
            double step = shot.gray(at, MIDDLE_ROW) - shot.gray(at + 1, MIDDLE_ROW);
            sum += step;
            first += step * at;
            second += step * at * at;
        }
        return Math.sqrt(second / sum - first / sum * (first / sum));
    }

    /** The left edge of the tag's black border. */
    private static int edge() {
        return (int) Math.round(320 - EyeOptions.defaults().focalPx() * 0.3);
    }

    @Test
    void lensAndMotionWidenAnEdgeAsTheyShould() {
        double sharp = edgeWidthPx(shot(Effects.CLEAN), edge());
        assertThat(sharp).isLessThan(0.6);
        assertThat(edgeWidthPx(shot(new Effects(1.5, 0, 0, 0, 1, 1)), edge())).isCloseTo(1.5, within(0.15));
        assertThat(edgeWidthPx(shot(new Effects(4, 0, 0, 0, 1, 1)), edge())).isCloseTo(4, within(0.3));
        // A box's standard deviation is its width divided by the root of 12.
        assertThat(edgeWidthPx(shot(new Effects(0, 0, 14, 0, 1, 1)), edge())).isCloseTo(14 / 3.46, within(0.3));
    }

    @Test
    void aTurnSmearsByHowFarItGoesDuringTheExposure() {
        EyeOptions options = Shot.with(Effects.CLEAN.withExposureMillis(20));
        // 20 ms at 1.5 rad/s are 0.03 rad, 16.6 pixels in the middle of the picture.
        Shot turning = new Shot(new Eye(options).render(NEAR_TAG, Pose.ORIGIN, -1.5, 0));
        assertThat(edgeWidthPx(turning, edge())).isCloseTo(16.6 / 3.46, within(0.3));
        Shot still = new Shot(new Eye(options).render(NEAR_TAG, Pose.ORIGIN, 0, 0));
        assertThat(still.isLike(shot(Effects.CLEAN))).isTrue();
    }

    @Test
    void noiseHasItsDeviationAndIsNewWithEachFrame() {
        Shot clean = shot(Effects.CLEAN);
        Eye eye = new Eye(Shot.with(new Effects(0, 8, 0, 0, 1, 1)));
        Shot noisy = new Shot(eye.render(NEAR_TAG, Pose.ORIGIN, 0, 7));
        double squares = 0;
        int count = 0;
        for (int y = 0; y < 480; y += 3) {
            for (int x = 0; x < 640; x += 3) {
                // Where no level is clipped at black or white.
                if (Math.abs(clean.gray(x, y) - 128) < 80) {
                    squares += Math.pow(noisy.gray(x, y) - clean.gray(x, y), 2);
                    count++;
                }
            }
        }
        assertThat(Math.sqrt(squares / count)).isCloseTo(8, within(0.3));
        assertThat(new Shot(eye.render(NEAR_TAG, Pose.ORIGIN, 0, 8)).isLike(noisy))
                .isFalse();
        assertThat(new Shot(eye.render(NEAR_TAG, Pose.ORIGIN, 0, 7)).isLike(noisy))
                .isTrue();
    }

    @Test
    void lightFallsFromOneSide() {
        Shot clean = shot(Effects.CLEAN);
        Shot dim = shot(new Effects(0, 0, 0, 0, 0.2, 1));
        assertThat(dim.gray(1, 10) / (double) clean.gray(1, 10)).isCloseTo(0.2, within(0.02));
        assertThat(dim.gray(320, 10) / (double) clean.gray(320, 10)).isCloseTo(0.6, within(0.02));
        assertThat(dim.gray(638, 10) / (double) clean.gray(638, 10)).isCloseTo(1, within(0.02));
    }

    @Test
    void theSameSeedIsTheSamePictureAndAnotherIsNot() {
        EyeOptions options = EyeOptions.defaults();
        Shot one = Shot.of(options.withSeed(5), NEAR_TAG);
        assertThat(Shot.of(options.withSeed(5), NEAR_TAG).isLike(one)).isTrue();
        assertThat(Shot.of(options.withSeed(6), NEAR_TAG).isLike(one)).isFalse();
    }

    @Test
    void allMistakesAreReportedAtOnce() {
        assertThatThrownBy(() -> new Effects(-1, 65, 61, Double.NaN, 1, 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("""
                        lens blur in pixels is -1.0; allowed is 0 to 5
                        noise in gray levels is 65.0; allowed is 0 to 64
                        motion blur in pixels is 61.0; allowed is 0 to 60
                        exposure in ms is NaN; allowed is 0 to 100
                        light at the right is 3.0; allowed is 0 to 2""");
        EyeOptions usual = EyeOptions.defaults();
        assertThatThrownBy(() -> usual.withSize(0, 4_000))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("""
                        picture width in pixels is 0; allowed is 16 to 1920
                        picture height in pixels is 4000; allowed is 16 to 1920""");
        assertThatThrownBy(() -> usual.withFieldOfViewDeg(121))
                .hasMessage("field of view in degrees is 121; allowed is 20 to 120");
        assertThatThrownBy(() -> usual.withHeightMm(250))
                .hasMessage("camera height in mm is 250; allowed is 50 to 200");
        assertThatThrownBy(() -> Effects.named("best"))
                .hasMessage("camera quality is 'best'; there are clean, typical and hard");
    }
}
