"""The DC motors of drives that have one, for tests that read their constants."""

from ropsim.model import DcMotor, Drive, VoltageAmplifier


def dc_motor(drive: Drive) -> DcMotor:
    """Return the motor of a drive that must be a DC motor."""
    assert isinstance(drive.motor, DcMotor)
    return drive.motor


def voltage_amplifier(drive: Drive) -> VoltageAmplifier:
    """Return the amplifier of a drive that must be one of voltages."""
    assert isinstance(drive.amplifier, VoltageAmplifier)
    return drive.amplifier
