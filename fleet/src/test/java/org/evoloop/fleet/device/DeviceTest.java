package org.evoloop.fleet.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.engine.Output;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

/** The converter of one device, with one input after the other. */
class DeviceTest implements DeviceListener {
    private static final long SECOND = 1_000_000_000L;

    private final Model lamp = ModelRecord.read("lamp-1", Models.SENDING_LAMP.bytes());
    private final List<Order> orders = new ArrayList<>();
    private final List<Output.Ended> ended = new ArrayList<>();
    private final Device device = new Device(lamp, 30 * SECOND, this, SECOND);
    private int dropped;

    @Override
    public void ordered(Order order) {
        orders.add(order);
    }

    @Override
    public void noted(Output.Notice notice) {
        if (notice instanceof Output.Ended end) {
            ended.add(end);
        } else if (notice instanceof Output.Dropped) {
            dropped++;
        }
    }

    @Override
    public void settled(DeviceState state, boolean isNew) {}

    @Test
    void anOrderIsGivenOnceAndItsAnswerMovesTheDevice() {
        press(2 * SECOND);
        assertThat(orders).extracting(Order::what).containsExactly("switch");
        assertThat(orders.get(0).deadlineNanos()).isEqualTo(32 * SECOND);
        answer(1, Answer.Outcome.SENT, 3 * SECOND);
        answer(1, Answer.Outcome.SENT, 4 * SECOND);
        assertThat(device.state().snapshot().at().original()).isEqualTo(new State("on"));
        assertThat(device.state().snapshot().steps()).isEqualTo(1);
    }

    @Test
    void aTimerIsDueBeforeWhatHappensLaterAndNotBeforeItsTime() {
        waiting();
        assertThat(device.dueNanos()).isEqualTo(6 * SECOND);
        device.due(6 * SECOND - 1);
        assertThat(orders).hasSize(1);
        device.due(6 * SECOND);
        device.due(6 * SECOND);
        assertThat(orders).hasSize(2);
    }

    @Test
    void aPressThatArrivesLateIsHandledBeforeATimerThatHasNotFiredYet() {
        waiting();
        press(5 * SECOND);
        assertThat(device.state().snapshot().at().evolved()).isEqualTo(new State("incandescentOn"));
        device.due(7 * SECOND);
        assertThat(orders).hasSize(1);
    }

    @Test
    void anOrderWithoutAnAnswerIsGivenUpAndTheDeviceIsAsked() {
        press(2 * SECOND);
        long due = device.dueNanos();
        assertThat(due).isEqualTo(62 * SECOND);
        device.due(due);
        assertThat(orders.get(1).kind()).isEqualTo(Order.Kind.LOCATE);
        device.answered(new Answer(2, Answer.Outcome.SENT, "", new State("on"), 63 * SECOND));
        assertThat(device.state().snapshot().at().original()).isEqualTo(new State("on"));
        assertThat(device.dueNanos()).isEqualTo(Device.NEVER);
    }

    @Test
    void anAnswerAfterTheLimitFindsTheOrderGivenUpEvenWithoutATickInBetween() {
        press(2 * SECOND);
        answer(1, Answer.Outcome.SENT, 62 * SECOND);
        assertThat(orders).extracting(Order::kind).containsExactly(Order.Kind.SEND, Order.Kind.LOCATE);
        assertThat(device.state().lost()).isNull();
        assertThat(device.state().snapshot().at().original()).isEqualTo(new State("on"));
    }

    @Test
    void otherModelsTakeOverBetweenTwoEventsOnly() {
        Model next = ModelRecord.read("lamp-2", Models.lamp(500).bytes());
        Model.Takeover takeover = lamp.to(next, Mapping.byName());
        press(2 * SECOND);
        assertThat(device.evolve(takeover, 2 * SECOND)).contains("not answered yet");
        answer(1, Answer.Outcome.SENT, 3 * SECOND);
        assertThat(device.evolve(takeover, 3 * SECOND)).isEmpty();
        assertThat(device.model()).isEqualTo("lamp-2");
        press(4 * SECOND);
        assertThat(device.dueNanos()).isEqualTo(4 * SECOND + SECOND / 2);
    }

    @Test
    void aTimerWaitsUntilTheQueueHasRoomForIt() {
        waiting();
        int most = lamp.rules().mostFacts();
        for (int asked = 0; asked <= most; asked++) {
            device.observed(new Occurrence.Asked(new Event("switch"), Values.NONE, 0, 5 * SECOND));
        }
        assertThat(device.state().snapshot().waiting()).hasSize(most);
        device.due(7 * SECOND);
        assertThat(device.dueNanos()).isEqualTo(65 * SECOND);
        answer(2, Answer.Outcome.FAILED, 8 * SECOND);
        assertThat(device.dueNanos()).isEqualTo(6 * SECOND);
        device.due(9 * SECOND);
        assertThat(device.dueNanos()).isEqualTo(68 * SECOND);
        for (int order = 3; order <= most + 2; order++) {
            answer(order, Answer.Outcome.FAILED, 10 * SECOND);
        }
        // What was asked for has failed; the timer, which was the last in the queue, switches the lamp off.
        assertThat(orders).hasSize(most + 3);
        answer(most + 3, Answer.Outcome.SENT, 11 * SECOND);
        assertThat(ended.get(ended.size() - 1).occurrence().source()).isEqualTo(Source.TIMER);
        assertThat(dropped).isZero();
    }

    private void waiting() {
        press(2 * SECOND);
        answer(1, Answer.Outcome.SENT, 3 * SECOND);
        press(4 * SECOND);
        assertThat(device.state().snapshot().at().evolved()).isEqualTo(new State("wait"));
    }

    private void press(long atNanos) {
        device.observed(new Occurrence.Heard(new Event("switch"), Values.NONE, Source.CONTROLLER, 0, atNanos));
    }

    private void answer(long sequence, Answer.Outcome outcome, long atNanos) {
        device.answered(new Answer(sequence, outcome, "", null, atNanos));
    }
}
