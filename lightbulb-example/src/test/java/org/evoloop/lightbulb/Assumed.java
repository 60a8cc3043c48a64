package org.evoloop.lightbulb;

import java.nio.file.Path;
import org.evoloop.console.Console;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.http.HttpExecute;
import org.evoloop.migration.Mapping;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.testkit.DeviceLine;
import org.evoloop.time.Clock;

/** What the snippets of the guides take for granted; {@link Snippet} compiles them as code of a subclass. */
@SuppressWarnings("NullAway.Init") // they are compiled only
abstract class Assumed {
    SystemEventConverter converter;
    SystemEventConverter upper;
    SystemEventConverter lower;
    PushMonitor monitor;
    Console console;
    Clock clock;
    BrokerAddress address;
    HttpExecute buttons;
    ModelPair models;
    StateMachine original;
    StateMachine evolved;
    Mapping mapping;
    Path file;
    LightBulb lamp;
    Receiver receiver;
    Kettle kettle;

    /** The code of a snippet of statements. */
    interface Statements {
        void run() throws Exception;
    }

    /** The same, with a result. */
    interface Answer {
        Object run() throws Exception;
    }

    void shown(Statements statements) {}

    void shown(Answer answer) {}

    interface Receiver {
        String poll();
    }

    interface Kettle {
        double celsius();
    }

    static class RobotKnowledge extends StateKnowledge {
        RobotKnowledge(ModelPair models) {
            super(models);
        }
    }

    static class RobotLink {
        RobotLink(DeviceLine line) {}

        PushMonitor monitor() {
            throw new UnsupportedOperationException();
        }

        EventExecute execute() {
            throw new UnsupportedOperationException();
        }
    }
}

interface Pump {
    void in();

    void out();

    void stop();

    boolean isFull();
}

interface Room {
    double celsius();

    void heat(boolean on);
}
