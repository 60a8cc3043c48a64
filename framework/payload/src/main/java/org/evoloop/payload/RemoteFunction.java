package org.evoloop.payload;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Reading;
import org.evoloop.function.Visit;
import org.jspecify.annotations.Nullable;

/**
 * A function that runs in another program, in any language. The program is told of each visit and says what to do, in JSON
 * objects. Each has a verb and the visit's number, so that what arrives late, about a visit that is over, does nothing.
 *
 * <p>{@code start}, with the visit's {@code state}, the {@code device}'s state, how the visit has begun ({@code beginning})
 * and the event's {@code values}, and {@code stop} are sent to the program. It answers, as often as it likes, with {@code
 * send}, {@code raise} or {@code finish} and an {@code event} with its {@code values}; with {@code progress} ({@code text}
 * and {@code readings}), {@code say} ({@code text}), and {@code fail} ({@code text}), which ends its part in this visit. A
 * {@code fail} without a visit is said in the program's name once it is gone.
 *
 * <p>A visit begins when the program is there. If the program is lost in the middle of it, the function has failed: the
 * visit lasts, but nothing more is heard in it, and the program is not told to start again until the state is entered again.
 *
 * <p>Threading: as {@link NewFunction}; for one converter.
 *
 * @since 0.1
 */
public final class RemoteFunction implements NewFunction {
    private static final Duration PAUSE = Duration.ofMillis(250);

    private final Channel channel;
    private volatile @Nullable Session current;

    /**
     * How a program is reached.
     *
     * <p>Threading: all methods may be called from any thread.
     *
     * @since 0.1
     */
    public interface Channel {
        /** Whether the program can be told anything. */
        boolean isUp();

        /**
         * Tells the program something, without waiting for it.
         *
         * @param verb that of the object, its member {@code do}
         * @return empty if it was sent; else why not
         */
        String tell(String verb, String json);

        /** Adds a listener; before the channel is opened. */
        void listen(Listener listener);

        /** Whom it reaches, for messages. */
        @Override
        String toString();
    }

    /**
     * Hears what a program says.
     *
     * @since 0.1
     */
    public interface Listener {
        /**
         * The program has said something.
         *
         * @param verb empty if it is the member {@code do} of the object
         * @param json an object
         */
        void heard(String verb, String json);

        /** The program is gone. */
        void lost(String why);
    }

    /** A function that runs in the program at the other end of {@code channel}, before that is opened. */
    public RemoteFunction(Channel channel) {
        this.channel = channel;
        channel.listen(new Listener() {
            @Override
            public void heard(String verb, String json) {
                Session session = current;
                if (session != null) {
                    session.hear(verb, json);
                }
            }

            @Override
            public void lost(String why) {
                Session session = current;
                if (session != null) {
                    session.lost(why);
                }
            }
        });
    }

    @Override
    public void run(Visit visit) {
        Session session = new Session(visit);
        current = session;
        visit.onEnd(session::end);
        session.start();
    }

    /** What the program and a visit have to say to each other. */
    private final class Session {
        private final Visit visit;
        private boolean started;
        private boolean over;

        Session(Visit visit) {
            this.visit = visit;
        }

        private JsonObject message(String verb) {
            return new JsonObject()
                    .put("do", verb)
                    .put("visit", visit.number())
                    .put("state", visit.state().name());
        }

        private void stop() {
            channel.tell("stop", message("stop").toString());
        }

        private void start() {
            if (!channel.isUp()) {
                visit.progress("waits for " + channel);
                visit.after(PAUSE, this::start);
                return;
            }
            synchronized (this) {
                started = true;
            }
            visit.progress("");
            String wrong = channel.tell(
                    "start",
                    message("start")
                            .put("device", visit.device().name())
                            .put("beginning", JsonObject.word(visit.beginning()))
                            .putSome("values", visit.values().byName())
                            .toString());
            if (!wrong.isEmpty()) {
                fail(wrong);
            }
        }

        /** Whether this visit has been started and nothing has ended it. */
        private synchronized boolean isOn() {
            return started && !over && visit.isActive();
        }

        /** Ends the program's part; false if it had not begun, or was over. */
        private synchronized boolean finish() {
            boolean was = started && !over;
            over |= was;
            return was;
        }

        private void end() {
            if (finish()) {
                stop();
            }
        }

        private void fail(String why) {
            if (finish()) {
                visit.failed(why);
                // It may still run, if only the way to it was lost.
                stopOnceUp();
            }
        }

        private void stopOnceUp() {
            if (channel.isUp()) {
                stop();
            } else {
                visit.after(PAUSE, this::stopOnceUp);
            }
        }

        void lost(String why) {
            fail("the function ended in the middle of the visit: " + why + "; it starts again with the next visit");
        }

        /** What is said is done on the thread of the visit's tasks, since it may have to wait for room. */
        void hear(String verb, String json) {
            if (isOn()) {
                try {
                    visit.after(Duration.ZERO, () -> take(verb, json));
                } catch (IllegalStateException flood) {
                    fail(channel + " says more than can be done: " + flood.getMessage());
                }
            }
        }

        private void take(String verb, String json) {
            if (!isOn()) {
                return;
            }
            try {
                JsonRecord said = JsonRecord.of(json);
                String what = verb.isEmpty() ? said.text("do", "") : verb;
                if (what.equals("fail") && !said.has("visit")) {
                    lost(said.text("text", channel + " is gone"));
                } else if (!what.isEmpty() && said.number("visit") == visit.number()) {
                    obey(what, said);
                }
            } catch (IllegalArgumentException wrong) {
                visit.failed(channel + " says " + json + ": " + wrong.getMessage());
            } catch (InterruptedException left) {
                Thread.currentThread().interrupt();
            }
        }

        private void obey(String what, JsonRecord said) throws InterruptedException {
            switch (what) {
                case "send" -> visit.send(said.text("event"), said.values("values"));
                case "raise" -> raise(said.text("event"), said.values("values"));
                case "finish" -> visit.finish(said.text("event"), said.values("values"));
                case "progress" -> visit.progress(said.text("text", ""), readings(said.values("readings")));
                case "say" -> visit.say(said.text("text"));
                case "fail" -> fail(said.text("text"));
                default ->
                    throw new IllegalArgumentException(
                            "'" + what + "' is none of send, raise, finish, progress, say and fail");
            }
        }

        private void raise(String event, Values values) throws InterruptedException {
            if (!visit.accepts(event)) {
                throw new IllegalArgumentException(
                        "the new model has no transition for '" + event + "' in " + visit.state());
            }
            visit.raise(event, values);
        }
    }

    private static List<Reading> readings(Values values) {
        List<Reading> readings = new ArrayList<>();
        values.byName().forEach((name, value) -> readings.add(new Reading(name, value, "")));
        return readings;
    }

    /** For messages. */
    @Override
    public String toString() {
        return "function in " + channel;
    }
}
