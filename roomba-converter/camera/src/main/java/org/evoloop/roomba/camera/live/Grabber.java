package org.evoloop.roomba.camera.live;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameReader;
import org.evoloop.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Owns the source: opens it, reads frames as fast as they arrive, and reopens it after a pause when they stop. */
final class Grabber implements Runnable {
    private static final Logger LOG = LoggerFactory.getLogger(Grabber.class);

    private static final Duration FIRST_PAUSE = Duration.ofMillis(250);
    private static final Duration LONGEST_PAUSE = Duration.ofSeconds(8);

    /** A driver or server that sends no frame for this long is reopened. */
    private static final Duration PATIENCE = Duration.ofSeconds(5);

    /** A read that fails at once may be due to a damaged frame; after this many in a row the source counts as ended. */
    private static final int FAILED_READS = 5;

    private static final Duration AT_ONCE = Duration.ofSeconds(1);

    private final CameraSource source;
    private final Supplier<FrameReader> opener;
    private final Clock clock;
    private final HealthTracker health;
    private final NewestFrame frames;
    private final AtomicLong damaged = new AtomicLong();
    private volatile boolean stopped;

    /** @param opener opens the source, or throws a {@link CameraException} */
    Grabber(CameraSource source, Supplier<FrameReader> opener, Clock clock, HealthTracker health, NewestFrame frames) {
        this.source = source;
        this.opener = opener;
        this.clock = clock;
        this.health = health;
        this.frames = frames;
    }

    long damagedFrames() {
        return damaged.get();
    }

    /** Stops it as soon as the driver returns; its thread must be interrupted as well. */
    void stop() {
        stopped = true;
    }

    @Override
    public void run() {
        Duration pause = FIRST_PAUSE;
        try {
            while (!stopped) {
                health.opening();
                String reason;
                try (FrameReader reader = opener.get()) {
                    if (readAll(reader)) {
                        pause = FIRST_PAUSE;
                    }
                    reason = source.isLive()
                            ? "camera " + source + " sends no frames any more; check its cable and power"
                            : "recording " + source + " is at its end";
                } catch (CameraException notThere) {
                    reason = notThere.getMessage();
                }
                if (stopped) {
                    return;
                }
                health.gone(reason);
                if (stopped || !source.isLive()) {
                    return;
                }
                LOG.warn("{}; trying again in {} ms", reason, pause.toMillis());
                clock.sleep(pause);
                pause = pause.multipliedBy(2).compareTo(LONGEST_PAUSE) < 0 ? pause.multipliedBy(2) : LONGEST_PAUSE;
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    /** Reads until no more frames arrive; returns whether any did. */
    private boolean readAll(FrameReader reader) throws InterruptedException {
        boolean any = false;
        int failedReads = 0;
        long lastGoodNanos = clock.nanoTime();
        while (!stopped) {
            Frame frame = frames.room();
            long askedNanos = clock.nanoTime();
            FrameReader.Received outcome = FrameReader.Received.NOTHING;
            try {
                outcome = reader.read(frame);
            } finally {
                if (outcome != FrameReader.Received.FRAME) {
                    frames.giveBack(frame);
                }
            }
            long nowNanos = clock.nanoTime();
            if (outcome == FrameReader.Received.NOTHING) {
                failedReads++;
            } else {
                // If reading succeeds again, the failed reads were frames that could not be decoded.
                damaged.addAndGet(failedReads);
                failedReads = 0;
            }
            if (outcome == FrameReader.Received.FRAME) {
                frames.publish(frame, nowNanos);
                any = true;
                lastGoodNanos = nowNanos;
                continue;
            }
            if (outcome == FrameReader.Received.DAMAGED) {
                damaged.incrementAndGet();
                health.damaged();
            }
            boolean waitedInVain = failedReads > 0 && nowNanos - askedNanos > AT_ONCE.toNanos();
            boolean showsNothing = source.isLive() && nowNanos - lastGoodNanos > PATIENCE.toNanos();
            if (failedReads >= FAILED_READS || waitedInVain || showsNothing) {
                break;
            }
        }
        frames.awaitLookedAt();
        return any;
    }
}
