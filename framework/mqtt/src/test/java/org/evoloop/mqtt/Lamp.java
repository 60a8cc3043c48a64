package org.evoloop.mqtt;

import java.time.Duration;
import java.util.List;
import org.evoloop.Alarm;
import org.evoloop.LightBulb;
import org.evoloop.Machines;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;

/** The light bulb's converter, with a link that can be interrupted. */
public final class Lamp implements DeviceLink, AutoCloseable {
    public final PushMonitor wallSwitch = new PushMonitor("WallSwitch");
    public final ManualClock clock = new ManualClock();
    public final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
    public final RecordingExecute bulb = new RecordingExecute("Bulb", "switch");
    public volatile boolean up = true;
    public volatile long battery = 93;
    public volatile String mood = "it's fine";

    public Lamp() {
        converter.addMonitor(wallSwitch);
        converter.addExecute(bulb);
        converter.addKnowledge(knowledge(PaperModels.lightBulb()));
        converter.addKnowledgeFactory(Lamp::knowledge);
        converter.watch((models, at, nanos) -> new Alarm("Nobody plays with the light", "switch"));
        converter.addLink(this);
        converter.build();
    }

    private static LightBulb knowledge(ModelPair models) {
        return new LightBulb(
                models,
                Duration.ofSeconds(2),
                visit -> visit.progress("warming up", List.of(Reading.of("warm", 40, "%"))));
    }

    /** The new model, or one in which the lamp goes off at once. */
    public StateMachine model(String reference) {
        return reference.endsWith("#new")
                ? PaperModels.lightBulb().evolved()
                : Machines.machine("plain", "off switch -> on", "on switch -> off");
    }

    /** Starts a shadow whose lamp goes off at once. */
    public void shadow() {
        ModelPair running = converter.knowledge().models();
        StateMachine plain = model("lamp.xml#plain");
        converter.shadow(Evolution.to(converter.knowledgeOf(new ModelPair(running.original(), plain)))
                .withoutWayBack());
    }

    @Override
    public boolean isUp() {
        return up;
    }

    @Override
    public String describe() {
        return up ? "in its socket" : "out of its socket";
    }

    @Override
    public List<Reading> readings() {
        return List.of(Reading.of("battery", battery, "%"), Reading.of("charging", false), Reading.of("mood", mood));
    }

    @Override
    public void close() {
        converter.close();
        clock.close();
    }
}
