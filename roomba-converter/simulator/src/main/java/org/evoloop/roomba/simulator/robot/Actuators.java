package org.evoloop.roomba.simulator.robot;

import org.evoloop.roomba.oi.ActuatorCommand.Drive;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.ActuatorCommand.DrivePwm;
import org.evoloop.roomba.oi.ActuatorCommand.Motors;
import org.evoloop.roomba.oi.ActuatorCommand.PwmMotors;
import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.CleaningMotors;
import org.evoloop.roomba.simulator.body.Wheel;
import org.evoloop.roomba.simulator.room.Pose;

/** Wheels and cleaning motors under the client's control. */
final class Actuators {
    private static final double FULL_DRIVE_PWM = 255;
    private static final double FULL_MOTOR_PWM = 127;

    private final Body body;
    private Drive requestedDrive = new Drive(0, 0);
    private DriveDirect requestedDirect = new DriveDirect(0, 0);

    Actuators(Body body) {
        this.body = body;
    }

    void drive(Drive drive) {
        requestedDrive = drive;
        double velocity = drive.velocityMmPerS();
        switch (drive.radiusMm()) {
            // The specification gives a radius of 0 no meaning; as a circle it would have no size.
            case 0, Drive.STRAIGHT, Short.MIN_VALUE -> body.drive(velocity, velocity);
            case Drive.SPIN_COUNTERCLOCKWISE -> body.drive(velocity, -velocity);
            case Drive.SPIN_CLOCKWISE -> body.drive(-velocity, velocity);
            default -> {
                double difference = velocity * Pose.WHEEL_BASE_MM / 2 / drive.radiusMm();
                body.drive(velocity + difference, velocity - difference);
            }
        }
    }

    void drive(DriveDirect drive) {
        requestedDirect = drive;
        body.drive(drive.rightMmPerS(), drive.leftMmPerS());
    }

    void drive(DrivePwm drive) {
        double perStep = Wheel.FASTEST_MM_PER_S / FULL_DRIVE_PWM;
        body.drive(drive.rightPwm() * perStep, drive.leftPwm() * perStep);
    }

    void clean(Motors motors) {
        body.setCleaningMotors(new CleaningMotors(
                power(motors, Motors.MAIN_BRUSH, Motors.MAIN_BRUSH_OUTWARD),
                power(motors, Motors.SIDE_BRUSH, Motors.SIDE_BRUSH_CLOCKWISE),
                power(motors, Motors.VACUUM, 0)));
    }

    private static double power(Motors motors, int bit, int reverseBit) {
        if ((motors.bits() & bit) == 0) {
            return 0;
        }
        return (motors.bits() & reverseBit) == 0 ? 1 : -1;
    }

    void clean(PwmMotors motors) {
        body.setCleaningMotors(new CleaningMotors(
                motors.mainBrushPwm() / FULL_MOTOR_PWM,
                motors.sideBrushPwm() / FULL_MOTOR_PWM,
                motors.vacuumPwm() / FULL_MOTOR_PWM));
    }

    /** The last one, obeyed or overtaken. */
    Drive requestedDrive() {
        return requestedDrive;
    }

    /** The last one, obeyed or overtaken. */
    DriveDirect requestedDirect() {
        return requestedDirect;
    }
}
