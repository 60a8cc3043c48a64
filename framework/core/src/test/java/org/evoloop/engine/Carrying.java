package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.engine.Scene.Act;
import org.evoloop.engine.World.Phase;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;

/** What the loop's components can do next with the occurrence in progress, including failing. */
final class Carrying {
    private final Snapshot now;
    private final World world;
    private final long time;
    private final List<Move> found = new ArrayList<>();

    private Carrying(Snapshot now, World world, long time) {
        this.now = now;
        this.world = world;
        this.time = time;
    }

    static List<Move> of(Snapshot now, World world, long time) {
        Carrying carrying = new Carrying(now, world, time);
        Work work = now.work();
        if (work != null && work.stage() != Work.Stage.INTERRUPTED) {
            carrying.proceed(work);
            carrying.fail(work);
        }
        // Also while something is in progress; then it must have no effect.
        boolean interrupted = work != null && work.stage() == Work.Stage.INTERRUPTED;
        if (world.phase == Phase.OPEN && (interrupted || !now.waiting().isEmpty() || now.followOwed())) {
            carrying.input(new Input.Ready(), world.copy());
        }
        return carrying.found;
    }

    private void input(Input input, World next) {
        found.add(Move.noticed(input, next));
    }

    private void proceed(Work work) {
        long number = work.pending().number();
        Output.Directive asked = world.asked;
        if (work.decision() == null) {
            for (Decision plan : world.plans) {
                input(new Input.Planned(number, plan, time), world.copy());
            }
        } else if (work.stage() == Work.Stage.RESUMED) {
            input(new Input.Planned(number, work.decision(), time), world.copy());
        } else if (asked instanceof Output.Send send) {
            announce(number, send.step());
        } else if (asked instanceof Output.Run && work.stage() != Work.Stage.RUNNING) {
            input(new Input.Running(number), world.copy());
        } else if (asked instanceof Output.Run) {
            input(new Input.EffectRun(number, "", time), done());
            if (world.may(Act.FAIL)) {
                World failed = world.spent(Act.FAIL);
                failed.asked = null;
                input(new Input.EffectRun(number, "it failed", time), failed);
            }
        } else if (asked instanceof Output.Locate) {
            locate(number);
        }
    }

    private World done() {
        World next = world.copy();
        next.asked = null;
        return next;
    }

    private void announce(long number, Step step) {
        if (step.conditional()) {
            input(new Input.Failed(number, "its guards do not hold", time), done());
        }
        World next = done();
        // Undone if the core does not let it be sent; see World.heard.
        next.flight = new World.Flight(number, step);
        input(new Input.Sending(number), next);
    }

    private void locate(long number) {
        if (!world.scene.canLocate()) {
            input(new Input.Located(number, null, time), done());
        } else if (world.answer != null) {
            input(new Input.Located(number, world.answer, time), done());
        } else if (world.unreported.isEmpty()) {
            World next = world.copy();
            next.answer = world.device;
            next.stray = null;
            found.add(Move.unnoticed("the device says that it is in " + world.device, next));
        }
    }

    private void fail(Work work) {
        long number = work.pending().number();
        boolean landed = world.flight != null && world.landed;
        if (world.may(Act.FAIL) && !landed) {
            World next = world.spent(Act.FAIL);
            next.noLongerSent();
            input(new Input.Failed(number, "it failed", time), next);
        }
        if (world.may(Act.DISMISS) && work.decision() == null) {
            input(new Input.Dismissed(number, time), world.spent(Act.DISMISS));
            input(new Input.Planned(number, new Decision.Refused(now.at(), "a rule"), time), world.spent(Act.DISMISS));
        }
        if (world.may(Act.GIVE_UP)) {
            giveUp(number, landed);
        }
    }

    private void giveUp(long number, boolean landed) {
        World next = world.spent(Act.GIVE_UP);
        next.stray = world.flight != null && !landed ? world.flight : world.stray;
        next.noLongerSent();
        input(new Input.GivenUp(number, "it was given up", time), next);
        if (landed && world.mayHideEffects()) {
            World hidden = next.copy();
            hidden.unreported.removeIf(token -> token instanceof Token.Effect);
            input(new Input.GivenUp(number, "it was given up, and its effect will not be reported", time), hidden);
        }
    }
}
