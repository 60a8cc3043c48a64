package org.evoloop.journal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.evoloop.engine.Core;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Writes each input before passing it to the core. When the segment is full it begins another one, whose snapshot
 * limits what a restart has to read; the input is then encoded again, since the new segment has no names yet.
 *
 * <p>While writing is impossible, nothing is begun that would be missing from the journal: events of controllers are
 * refused, and no step or effect is announced. Facts count all the same, and are in the snapshot with which the next
 * segment begins.
 */
final class Recorder implements Inputs {
    private final Core core;
    private final Segments segments;
    private final Consumer<Exception> failed;
    private final Runnable works;
    private final Encoder encoder;
    private boolean kept;

    Recorder(Core core, Segments segments, Consumer<Exception> failed, Runnable works) throws IOException {
        this.core = core;
        this.segments = segments;
        this.failed = failed;
        this.works = works;
        this.encoder = new Encoder(segments.masks());
        segments.begin(core, encoder.bytes());
    }

    /** Appends the encoded input; false if it has to be encoded again. */
    private boolean append() {
        boolean worked = segments.isWritable();
        try {
            kept = segments.append(encoder.bytes());
            if (!kept && segments.mayBegin()) {
                Path lost = segments.lost();
                segments.begin(core, encoder.bytes());
                if (lost != null) {
                    failed.accept(JournalException.damaged(
                            lost
                                    + " was removed, replaced or cut while it was written. The converter has begun the next"
                                    + " segment with its complete state",
                            Remedy.ofDamage(lost)));
                } else if (!worked) {
                    works.run();
                }
                return false;
            }
        } catch (IOException | InternalError e) {
            kept = false;
            segments.fail();
            if (worked) {
                failed.accept(Directory.cannotBeWritten(segments.path(), e));
            }
        }
        return true;
    }

    /** @throws JournalException if the last encoded input could not be written */
    private void requireKept() {
        if (!kept) {
            throw new JournalException(
                    "the journal " + segments.path() + " cannot be written, so nothing is sent; make room on its disk");
        }
    }

    @Override
    public void observed(Occurrence occurrence) {
        do {
            encoder.observed(occurrence);
        } while (!append());
        if (kept || occurrence.isFact() || !occurrence.source().isButton()) {
            core.observed(occurrence);
        } else {
            core.refuse(occurrence);
        }
    }

    @Override
    public void sending(long number) {
        do {
            encoder.sending(number);
        } while (!append());
        requireKept();
        segments.forceIntent();
        core.sending(number);
    }

    @Override
    public void running(long number) {
        do {
            encoder.running(number);
        } while (!append());
        requireKept();
        segments.forceIntent();
        core.running(number);
    }

    /** Other rules are written in the head of a new segment; equal ones need none. */
    @Override
    public void changed(Rules rules, long atNanos) {
        if (!segments.isBy(rules)) {
            core.changed(rules, atNanos);
            segments.suspend();
            return;
        }
        do {
            encoder.changed(rules, atNanos);
        } while (!append());
        core.changed(rules, atNanos);
    }

    /**
     * Other models are written in the head of a new segment, together with their state: as soon as the segment has
     * begun they have taken over.
     */
    @Override
    public void evolved(Swap swap, long atNanos) {
        Core evolved = new Core(core.rules(), core.snapshot(), output -> {});
        evolved.evolved(swap, atNanos);
        ByteWriter names;
        try {
            names = segments.beginPrepared(evolved);
        } catch (IOException | InternalError e) {
            throw new JournalException(
                    "the journal " + segments.path() + " cannot be written, so the models stay; make room on its disk",
                    e);
        }
        // If that fails, the previous segment continues, with its names.
        encoder.use(names);
        core.evolved(swap, atNanos);
    }

    @Override
    public void opened(long atNanos) {
        do {
            encoder.opened(atNanos);
        } while (!append());
        core.opened(atNanos);
    }

    @Override
    public void closing() {
        do {
            encoder.closing();
        } while (!append());
        core.closing();
    }

    @Override
    public void closed() {
        do {
            encoder.closed();
        } while (!append());
        core.closed();
    }

    @Override
    public void recovered(long atNanos) {
        do {
            encoder.recovered(atNanos);
        } while (!append());
        core.recovered(atNanos);
    }

    @Override
    public void timerDue(long visit, Event event, long atNanos) {
        do {
            encoder.timerDue(visit, event, atNanos);
        } while (!append());
        core.timerDue(visit, event, atNanos);
    }

    /** Not recorded if nothing waits, since it has no effect then. */
    @Override
    public void ready() {
        if (core.hasNext()) {
            do {
                encoder.ready();
            } while (!append());
        }
        core.ready();
    }

    @Override
    public void planned(long number, Decision decision, long atNanos) {
        do {
            encoder.planned(number, decision, atNanos);
        } while (!append());
        core.planned(number, decision, atNanos);
    }

    @Override
    public void dismissed(long number, long atNanos) {
        do {
            encoder.dismissed(number, atNanos);
        } while (!append());
        core.dismissed(number, atNanos);
    }

    @Override
    public void sent(long number, boolean inOrder, long atNanos) {
        do {
            encoder.sent(number, inOrder, atNanos);
        } while (!append());
        core.sent(number, inOrder, atNanos);
    }

    @Override
    public void effectRun(long number, String failure, long atNanos) {
        do {
            encoder.effectRun(number, failure, atNanos);
        } while (!append());
        core.effectRun(number, failure, atNanos);
    }

    @Override
    public void located(long number, @Nullable State state, long atNanos) {
        do {
            encoder.located(number, state, atNanos);
        } while (!append());
        core.located(number, state, atNanos);
    }

    @Override
    public void failed(long number, String reason, long atNanos) {
        do {
            encoder.failed(number, reason, atNanos);
        } while (!append());
        core.failed(number, reason, atNanos);
    }

    @Override
    public void givenUp(long number, String reason, long atNanos) {
        do {
            encoder.givenUp(number, reason, atNanos);
        } while (!append());
        core.givenUp(number, reason, atNanos);
    }
}
